#include <burnish/material/measured/alta_file.h>
#include <burnish/material/measured/gonio_pairs.h>
#include <burnish/material/measured/gonio_table.h>
#include <burnish/material/measured/half_angle_curve.h>
#include <burnish/material/measured/half_difference.h>
#include <burnish/material/measured/number_text.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

constexpr std::string_view kOutputs[] = {"INV_STERADIAN", "INV_STERADIAN_COSINE_FACTOR", "RGB_COLOR"};

std::array<double, 4> angles_of(const DirectionPair& pair) {
    const auto theta = [](const Vec3f& w) { return std::atan2(std::hypot(w.x, w.y), w.z); };
    return {theta(pair.wi), std::atan2(pair.wi.y, pair.wi.x), theta(pair.wo), std::atan2(pair.wo.y, pair.wo.x)};
}

/// How three columns become theta_i, phi_i, theta_o, phi_o.
struct Parametrisation {
    std::string_view name;
    std::array<double, 4> (*angles)(const double* columns);
};

constexpr Parametrisation kInputs[] = {
    {"ISOTROPIC_TL_TV_PROJ_DPHI",
     [](const double* x) {
         return std::array{x[0], 0.0, std::hypot(x[1], x[2]), std::atan2(x[2], x[1])};
     }},
    {"ISOTROPIC_TV_TL_DPHI",
     [](const double* x) {
         return std::array{x[1], 0.0, x[0], x[2]};
     }},
    {"RUSIN_TH_TD_PD", [](const double* x) {
         return angles_of(directions({static_cast<float>(x[0]), 0, static_cast<float>(x[1]), static_cast<float>(x[2])}));
     }}};

struct Header {
    size_t angles = 0, values = 0;
    std::string_view input, output;
};

std::string listed(std::string_view name, std::string list) { return (list.empty() ? "" : list + ", ") + std::string(name); }

Header read_header(const NumberText& text) {
    Header header;
    for (const NumberText::Line& line : text.lines()) {
        const std::vector<std::string_view> words = burnish::words(line.text);
        if (words.size() == 2 && words[0] == "#PARAM_IN") header.input = words[1];
        if (words.size() == 2 && words[0] == "#PARAM_OUT") header.output = words[1];
        if (words.size() != 3 || words[0] != "#DIM") continue;
        header.angles = words[1] == "1" ? 1 : words[1] == "3" ? 3 : 0;
        header.values = words[2] == "1" ? 1 : words[2] == "3" ? 3 : 0;
    }
    std::string outputs, inputs = "COS_TH";
    for (const std::string_view name : kOutputs) outputs = listed(name, outputs);
    for (const Parametrisation& p : kInputs) inputs = listed(p.name, inputs);
    const bool input_known = std::ranges::find(kInputs, header.input, &Parametrisation::name) != std::end(kInputs);
    if (header.input != "COS_TH" && !input_known) text.refuse("#PARAM_IN: burnish reads " + inputs);
    if (std::ranges::find(kOutputs, header.output) == std::end(kOutputs)) text.refuse("#PARAM_OUT: burnish reads " + outputs);
    if (header.angles != (input_known ? 3 : 1) || header.values == 0)
        text.refuse("#DIM: expected " + std::string(input_known ? "3" : "1") + " columns of angles and 1 or 3 of values");
    return header;
}

/// Calls `take(columns of angles, value)` for every row.
template <class Take>
void for_each_row(const NumberText& text, const Header& header, Take take) {
    for (const NumberText::Line& line : text.lines()) {
        if (line.text.starts_with('#')) continue;
        const std::vector<double> row = text.numbers(line);
        if (row.size() != header.angles + header.values)
            text.refuse(line, "expected " + std::to_string(header.angles + header.values) + " numbers, found " +
                                  std::to_string(row.size()));
        const auto value = [&](size_t c) { return static_cast<float>(row[header.angles + (header.values == 1 ? 0 : c)]); };
        take(row.data(), Color3f(value(0), value(1), value(2)));
    }
}

}  // namespace

std::shared_ptr<const MeasuredBrdf> read_alta(const std::string& file) {
    const NumberText text(file);
    const Header header = read_header(text);
    const bool times_cosine = header.output == "INV_STERADIAN_COSINE_FACTOR";
    std::shared_ptr<MeasuredBrdf> table;
    if (header.input == "COS_TH") {
        if (times_cosine) text.refuse("#PARAM_OUT: a curve over COS_TH has no cosine to divide by");
        std::vector<std::pair<float, Color3f>> points;
        for_each_row(text, header, [&](const double* x, const Color3f& f) {
            points.emplace_back(static_cast<float>(x[0]),
                                Color3f(std::max(f.x, 0.0f), std::max(f.y, 0.0f), std::max(f.z, 0.0f)));
        });
        if (!points.empty()) table = std::make_shared<HalfAngleCurve>(std::move(points));
    } else {
        const auto angles = std::ranges::find(kInputs, header.input, &Parametrisation::name)->angles;
        std::vector<BrdfSample> samples;
        for_each_row(text, header, [&](const double* x, const Color3f& value) {
            const auto [theta_i, phi_i, theta_o, phi_o] = angles(x);
            if (const auto sample = gonio_sample({theta_i, phi_i, theta_o, phi_o, value}, times_cosine))
                samples.push_back(*sample);
        });
        if (!samples.empty()) table = std::make_shared<GonioTable>(std::move(samples), true);
    }
    if (!table) text.refuse("no row is above the horizon");
    table->set_file(file);
    return table;
}

}  // namespace burnish
