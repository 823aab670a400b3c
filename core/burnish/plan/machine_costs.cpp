#include <burnish/plan/machine_costs.h>

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/base/json_text.h>
#include <burnish/costs_json.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace burnish {
namespace {

using nlohmann::json;

constexpr double kNanoseconds = 1e-9;
constexpr std::string_view kFields[] = {"machine", "cores", "nanoseconds", "evaluation"};
constexpr const char* kRemedy = "; run burnish calibrate again";

/// Four digits tell what a measurement knows.
json rounded(double seconds) {
    const double value = seconds / kNanoseconds;
    if (value <= 0) return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3);
    return to_json_number(static_cast<float>(std::round(value / unit) * unit));
}

double seconds_in(const JsonFields& fields, std::string_view key) {
    return static_cast<double>(fields.number(key, {0, 1e12})) * kNanoseconds;
}

MachineCosts read_costs(const json& document, const std::string& where) {
    const JsonFields fields(document, where);
    fields.expect_only(kFields);
    MachineCosts costs;
    costs.machine = fields.text("machine"), fields.at("cores");
    costs.cores = fields.whole_number("cores", {1, 4096}, 1);
    const JsonFields constants(fields.at("nanoseconds"), fields.path("nanoseconds"));
    std::vector<std::string_view> known;
    for (const CostField& field : cost_fields()) {
        known.push_back(field.name);
        costs.*field.value = seconds_in(constants, field.name);
    }
    constants.expect_only(known);
    const JsonFields models(fields.at("evaluation"), fields.path("evaluation"));
    for (const auto& item : fields.at("evaluation").items()) costs.evaluation[item.key()] = seconds_in(models, item.key());
    return costs;
}

MachineCosts users_costs() {
    const std::filesystem::path file = costs_file();
    std::error_code ignored;
    if (file.empty() || !std::filesystem::exists(file, ignored)) return shipped_costs();
    try {
        return costs_from_json(read_json(file.string(), "calibration"), file.string());
    } catch (const Error& error) {
        const std::string message = error.what();
        throw Error(error.code(), message.ends_with(kRemedy) ? message : message + kRemedy);
    }
}

}  // namespace

std::span<const CostField> cost_fields() {
    using M = MachineCosts;
    static constexpr CostField fields[] = {
        {"pyramid_texel", "light filtered for regular and filtered_importance, per texel", &M::pyramid_texel},
        {"stack_texel", "light filtered for fitted and for sparse shading, per texel", &M::stack_texel},
        {"table_lookup", "table of a lobe, per node and lookup", &M::table_lookup},
        {"fit_lookup", "fit of one lookup to a view of a round lobe, one core", &M::fit_lookup},
        {"turned_fit_lookup", "the same of a long lobe", &M::turned_fit_lookup},
        {"pixel", "dense shading, per lobe and pixel", &M::pixel},
        {"lookup", "regular and filtered_importance, per lookup there", &M::lookup},
        {"stack_lookup", "fitted, per lookup there", &M::stack_lookup},
        {"sun", "per lobe, pixel and sun", &M::sun},
        {"sparse_pixel", "sparse shading, per pixel of the frame", &M::sparse_pixel},
        {"reference_lookup", "reference, per lookup", &M::reference_lookup},
        {"near_ray", "a lookup under lights that are near", &M::near_ray},
        {"maps", "factored, the maps of a material", &M::maps},
        {"map_pixel", "factored, per pixel", &M::map_pixel},
    };
    return fields;
}

std::filesystem::path costs_file() {
    const auto variable = [](const char* name) -> std::filesystem::path {
        const char* value = std::getenv(name);
        return value ? value : "";
    };
    if (const std::filesystem::path own = variable("BURNISH_COSTS"); !own.empty()) return own;
    if (const std::filesystem::path cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache / "burnish/costs.json";
    const std::filesystem::path home = variable("HOME");
    return home.empty() ? home : home / ".cache/burnish/costs.json";
}

MachineCosts costs_from_json(const json& document, const std::string& where) {
    try {
        return read_costs(document, where);
    } catch (const Error& error) {
        throw Error(error.code(), error.what() + std::string(kRemedy));
    }
}

json costs_to_json(const MachineCosts& costs) {
    json document = {{"machine", costs.machine}, {"cores", costs.cores}};
    for (const CostField& field : cost_fields()) document["nanoseconds"][field.name] = rounded(costs.*field.value);
    for (const auto& [model, seconds] : costs.evaluation) document["evaluation"][model] = rounded(seconds);
    return document;
}

const MachineCosts& shipped_costs() {
    static const MachineCosts costs = costs_from_json(json::parse(kCostsJson), "the shipped costs");
    return costs;
}

const MachineCosts& machine_costs() {
    static const MachineCosts costs = users_costs();
    return costs;
}

}  // namespace burnish
