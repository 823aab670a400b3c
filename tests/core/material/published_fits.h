// Reads the tables of published fits (public/brdf_fits/*.csv), and the SGD equation that one of them is of.
#pragma once

#include <burnish/base/types.h>
#include <core/data.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace burnish {

struct FitRow {
    std::string material;
    std::map<std::string, double> values;

    double operator[](const std::string& column) const { return values.at(column); }
    bool has(const std::string& column) const { return values.contains(column); }
    /// Columns name_r, name_g, name_b.
    Color3f color(const std::string& name) const {
        const auto channel = [&](const char* suffix) { return static_cast<float>(values.at(name + suffix)); };
        return {channel("_r"), channel("_g"), channel("_b")};
    }
};

/// One row a material; the columns after the first are numbers.
inline std::vector<FitRow> read_fits(const std::string& name) {
    std::ifstream csv(*data_path("public/brdf_fits/" + name + ".csv"));
    const auto fields_of = [](const std::string& line) {
        std::istringstream text(line);
        std::vector<std::string> fields;
        for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
        return fields;
    };
    std::string line;
    std::getline(csv, line);
    const std::vector<std::string> columns = fields_of(line);
    std::vector<FitRow> rows;
    while (std::getline(csv, line)) {
        const std::vector<std::string> fields = fields_of(line);
        FitRow row{fields.at(0), {}};
        for (size_t i = 1; i < columns.size(); ++i) row.values[columns[i]] = std::stod(fields.at(i));
        rows.push_back(row);
    }
    return rows;
}

/// Bagher et al. 2012 as the table has it, f in 1/sr of the channel `suffix`, with the fitted G1 and Fresnel; unit vectors.
inline double sgd_brdf(const FitRow& row, const std::string& suffix, const Imath::V3d& wo, const Imath::V3d& wi) {
    const auto p = [&](const char* name) { return row[name + suffix]; };
    const auto G1 = [&](double cosine) {
        const double past = std::max(0.0, std::acos(cosine) - p("theta0"));
        return std::clamp(1 + p("lambda") * (1 - std::exp(p("c") * std::pow(past, p("k")))), 0.0, 1.0);
    };
    const Imath::V3d h = (wo + wi).normalized();
    const double cos_d = wo.dot(h), x = p("alpha") + (1 / (h.z * h.z) - 1) / p("alpha");
    const double D = p("kap") * std::exp(-x) / (M_PI * std::pow(x, p("p")) * std::pow(h.z, 4));
    const double F = p("F0") - p("F1") * cos_d + (1 - p("F0")) * std::pow(1 - cos_d, 5);
    return (p("rhoD") + p("rhoS") * F * D * G1(wo.z) * G1(wi.z) / (wo.z * wi.z)) / M_PI;
}

}  // namespace burnish
