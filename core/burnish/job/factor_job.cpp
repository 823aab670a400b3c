#include <burnish/job/factor_job.h>

#include <burnish/base/error.h>
#include <burnish/factor/parametrization.h>
#include <burnish/job/settings.h>
#include <burnish/material/measured/read_measured.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 17> kOwnFields = {
    "material", "parametrization", "method", "quality",  "mapping", "size",  "grid",   "terms", "measure",
    "weight",   "smoothness",      "polish", "prescale", "white",   "alpha", "output", "png"};
constexpr std::array<std::string_view, 5> kOtherSettings = {"estimator", "samples", "threads", "beauty_space", "ocio_config"};

/// What "quality" stands for.
struct Sizes {
    int texels, grid;
};
constexpr Sizes kSizes[] = {{16, 10}, {32, 20}, {64, 26}};

template <class Choice>
Choice choice(const JsonFields& fields, std::string_view key, std::span<const std::string_view> names, Choice fallback) {
    if (!fields.has(key)) return fallback;
    return static_cast<Choice>(std::ranges::find(names, fields.name(key, names)) - names.begin());
}

/// Of the environment, and what decides how lighting is sampled.
bool is_scene_setting(std::string_view name) {
    const auto same = [&](const Setting& setting) { return setting.name == name && setting.section == "lights"; };
    return std::ranges::any_of(settings(), same) || std::ranges::find(kOtherSettings, name) != kOtherSettings.end();
}

std::vector<std::string_view> known_fields() {
    std::vector<std::string_view> names(kOwnFields.begin(), kOwnFields.end());
    names.push_back("glsl");
    for (const Setting& setting : settings())
        if (is_scene_setting(setting.name)) names.push_back(setting.name);
    return names;
}

json scene_settings(const json& values) {
    json settings = json::object();
    for (const auto& [key, value] : values.items())
        if (is_scene_setting(key)) settings[key] = value;
    return settings;
}

/// Measured pairs are so few that most texels are only told by their neighbours.
bool is_sparse(const FactorJob& job) { return job.scene.environment.empty() && is_measured_name(job.material); }

FactoriseSettings maps_from_json(const JsonFields& fields, const Sizes& sizes, bool sparse) {
    constexpr float kSparseSmoothness = 1;
    constexpr std::array<std::string_view, 2> kSpheres = {"double_parabolic", "cube"};
    FactoriseSettings maps;
    maps.size = fields.whole_number("size", {DirectionMap::kLeastSize, DirectionMap::kMostSize}, sizes.texels);
    if (fields.has("mapping")) maps.sphere = mapping_by_name(fields.name("mapping", kSpheres));
    maps.smoothness = fields.number("smoothness", {0, 1000}, sparse ? kSparseSmoothness : maps.smoothness);
    maps.terms = fields.whole_number("terms", {0, 4}, maps.terms);
    maps.polish = fields.boolean("polish", maps.polish);
    return maps;
}

QuantiseSettings eight_bit_from_json(const JsonFields& fields) {
    QuantiseSettings eight_bit;
    eight_bit.white = fields.number("white", {0, 1e12}, 0);
    eight_bit.alpha = fields.boolean("alpha", eight_bit.alpha);
    if (!fields.has("prescale")) return eight_bit;
    const json& list = fields.at("prescale");
    if (!list.is_array() || !std::ranges::all_of(list, [](const json& weight) { return weight.is_number(); }))
        fail_expected(fields.path("prescale"), "a list of numbers, of the colour and of each map", list);
    for (const json& weight : list) eight_bit.weights.push_back(weight.get<float>());
    return eight_bit;
}

void check(const FactorJob& job, const std::string& where) {
    const auto refuse = [&](const std::string& why) { throw Error(ErrorCode::bad_argument, where + ": " + why); };
    if (job.material.empty()) refuse("no material: name a preset, a file or a measured table");
    if (job.scene.estimator.kind == EstimatorKind::factored)
        refuse("estimator factored shades from maps; take another one to make them from");
}

}  // namespace

FactorJob factor_job_from_json(const json& values, const std::string& where) {
    const JsonFields fields(values, where);
    fields.expect_only(known_fields());
    FactorJob job;
    const bool is_json = fields.has("material") && fields.at("material").is_object();
    job.material = is_json ? fields.at("material").dump() : fields.text("material");
    set_settings(job.scene, scene_settings(values), where);
    job.parametrization = fields.text("parametrization");
    if (!job.parametrization.empty()) parametrization_by_name(job.parametrization);
    job.method = choice(fields, "method", kFactorMethods, job.method);
    const Sizes sizes = kSizes[static_cast<size_t>(choice(fields, "quality", kFactorQualities, FactorQuality::normal))];
    job.maps = maps_from_json(fields, sizes, is_sparse(job));
    if (fields.has("measure")) job.measure = choice(fields, "measure", kFactorMeasures, FactorMeasure::display);
    job.grid = fields.whole_number("grid", {4, 64}, sizes.grid);
    job.weight = choice(fields, "weight", kViewWeights, job.weight);
    job.eight_bit = eight_bit_from_json(fields);
    job.output = fields.text("output"), job.png = fields.text("png"), job.glsl = fields.text("glsl");
    check(job, where);
    return job;
}

}  // namespace burnish
