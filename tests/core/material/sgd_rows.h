// The published SGD fits of the 100 MERL materials, as the test data has them.
#pragma once

#include <burnish/material/parameters.h>
#include <core/data.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace burnish {

struct SgdRow {
    std::string material;
    std::map<std::string, std::array<double, 3>> columns;  // "alpha" -> red, green, blue

    double at(const std::string& name, int channel) const { return columns.at(name)[static_cast<size_t>(channel)]; }
};

/// Rows of brdf_fits/<file>; none where there is no test data.
inline std::vector<SgdRow> sgd_rows(const std::string& file) {
    const auto path = data_path("public/brdf_fits/" + file);
    std::vector<SgdRow> rows;
    if (!path) return rows;
    std::ifstream text(*path);
    std::string line, cell;
    std::vector<std::string> head;
    std::getline(text, line);
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) head.push_back(cell);
    while (std::getline(text, line)) {
        SgdRow row;
        std::istringstream cells(line);
        for (const std::string& column : head) {
            std::getline(cells, cell, ',');
            const size_t name_length = column.size() - 2;
            if (column == "material") row.material = cell;
            if (column[name_length] != '_') continue;
            row.columns[column.substr(0, name_length)][std::string("rgb").find(column.back())] = std::stod(cell);
        }
        rows.push_back(row);
    }
    return rows;
}

/// The lobe of a row, with the published fit of G1 or with Smith's own.
inline LobeParameters sgd_lobe(const SgdRow& row, bool published_G1) {
    LobeParameters lobe;
    lobe.model = ModelId::sgd;
    for (const char* name : {"alpha", "p", "lambda", "c", "k"})
        for (int k = 0; k < 3; ++k) lobe.extra.push_back(static_cast<float>(std::min(row.at(name, k), 1e38)));
    if (!published_G1) std::fill(lobe.extra.begin() + 6, lobe.extra.begin() + 9, 0.0f);
    lobe.fresnel.kind = FresnelKind::generalised_schlick;
    for (int k = 0; k < 3; ++k) {
        lobe.tint[k] = static_cast<float>(row.at("rhoS", k));
        lobe.fresnel.eta[k] = static_cast<float>(row.at("F0", k)), lobe.fresnel.k[k] = static_cast<float>(row.at("F1", k));
    }
    return lobe;
}

}  // namespace burnish
