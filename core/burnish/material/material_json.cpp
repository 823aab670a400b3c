// Materials to and from JSON, the form of the shot file:
//
//     {"kd": 0.2, "lobes": [{"model": "kurt", "ks": 0.8, "mx": 0.1, "my": 0.1, "r0": 0.05, "alpha": 0.3}, ...]}
//
// "kd_coupled": true leaves to the diffuse part only what the lobes do not return. A material of one lobe may leave "lobes" out and hold the lobe's fields itself. "model" beside "lobes" is the lobes' default.
#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/material/any_model.h>
#include <burnish/material/library.h>
#include <burnish/material/measured/table_files.h>
#include <burnish/material/metals.h>
#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace burnish {

namespace {

using nlohmann::json;
using Names = std::vector<std::string_view>;

constexpr NumberRange kStrength{0, 1000}, kReflectivity{0, 1}, kWidth{kMinWidth, 1}, kIndex{0, 100};
constexpr NumberRange kFittedFresnel{-1000, 1000}, kDipPower{1, 20};  // fits of measurements need not be physical
constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<std::string_view, 4> kFresnelKeys{"r0", "ior", "eta", "metal"};
constexpr std::array<std::string_view, 3> kWidthKeys{"m", "mx", "roughness"};

struct PerPixelName {
    std::string_view name;
    bool PerPixel::*flag;
};
constexpr PerPixelName kPerPixel[] = {{"roughness", &PerPixel::roughness},
                                      {"anisotropy", &PerPixel::anisotropy},
                                      {"rotation", &PerPixel::rotation},
                                      {"tint", &PerPixel::tint},
                                      {"weight", &PerPixel::weight}};

Names lobe_keys(const ModelInfo& model) {
    Names keys{"model", "ks", "kt",  "tint",      "m",   "mx",  "my", "roughness", "anisotropy", "rotation_deg",
               "r0",    "f1", "dip", "dip_power", "ior", "eta", "k",  "metal",     "per_pixel"};
    for (const ModelParameter& parameter : model.parameters) keys.push_back(parameter.name);
    if (model.name == model_info(ModelId::table).name) keys.push_back("table");
    return keys;
}

/// Schlick's curve and what bends it.
Fresnel bent_schlick_from_json(const JsonFields& lobe) {
    lobe.expect_at_most_one(std::array<std::string_view, 2>{"f1", "dip"});
    const Color3f r0 = lobe.color("r0", kFittedFresnel);
    if (lobe.has("f1")) return {FresnelKind::generalised_schlick, r0, lobe.color("f1", kFittedFresnel)};
    return {FresnelKind::lazanyi, r0, lobe.color("dip", kFittedFresnel), false,
            lobe.number("dip_power", kDipPower, Fresnel{}.power)};
}

Fresnel fresnel_from_json(const JsonFields& lobe) {
    lobe.expect_at_most_one(kFresnelKeys);
    if (lobe.has("f1") || lobe.has("dip")) return bent_schlick_from_json(lobe);
    if (lobe.has("r0")) return {FresnelKind::schlick, lobe.color("r0", kReflectivity)};
    if (lobe.has("ior")) return {FresnelKind::dielectric, Color3f(lobe.number("ior", {0.1, 10}))};
    if (lobe.has("metal")) {
        Names names;
        for (const Metal& metal : metals()) names.insert(names.end(), {metal.name, metal.alias});
        const std::string word = lobe.name("metal", names);
        const auto metal = std::ranges::find_if(metals(), [&](const Metal& m) { return m.name == word || m.alias == word; });
        return {FresnelKind::conductor, metal->eta, metal->k};
    }
    if (lobe.has("eta") || lobe.has("k")) return {FresnelKind::conductor, lobe.color("eta", kIndex), lobe.color("k", kIndex)};
    return {};
}

/// Widths from one of three spellings: "mx" and "my", "m", or the artist's "roughness" r with m = r^2; the latter two may be
/// stretched by "anisotropy".
Vec2f widths_from_json(const JsonFields& lobe) {
    lobe.expect_at_most_one(kWidthKeys);
    if (lobe.has("mx") || lobe.has("my")) {
        lobe.expect_at_most_one(std::array<std::string_view, 3>{"my", "m", "roughness"});
        lobe.expect_at_most_one(std::array<std::string_view, 2>{"mx", "anisotropy"});
        return {lobe.number("mx", kWidth), lobe.number("my", kWidth)};
    }
    const float r = lobe.number("roughness", {0, 1}, 0);
    const float m = lobe.has("roughness") ? std::max(r * r, kMinWidth) : lobe.number("m", kWidth, LobeParameters{}.mx);
    return lobe.has("anisotropy") ? anisotropic_widths(m, lobe.number("anisotropy", {-1, 1})) : Vec2f(m, m);
}

PerPixel per_pixel_from_json(const JsonFields& lobe) {
    PerPixel result;
    if (!lobe.has("per_pixel")) return result;
    const json& list = lobe.at("per_pixel");
    const std::string where = lobe.path("per_pixel");
    if (!list.is_array()) fail_expected(where, "a list such as [\"roughness\", \"tint\"]", list);
    Names names;
    for (const PerPixelName& entry : kPerPixel) names.push_back(entry.name);
    for (size_t i = 0; i < list.size(); ++i) {
        const std::string word = name_from_json(list[i], where + "[" + std::to_string(i) + "]", names);
        result.*std::ranges::find(kPerPixel, word, &PerPixelName::name)->flag = true;
    }
    return result;
}

ModelId model_from_json(const JsonFields& fields, ModelId fallback) {
    if (!fields.has("model")) return fallback;
    Names names;
    for (const ModelInfo& info : models()) names.push_back(info.name);
    return model_by_name(fields.name("model", names));
}

bool names_width(const JsonFields& lobe) {
    return std::ranges::any_of(kWidthKeys, [&](std::string_view key) { return lobe.has(key); });
}

/// The model's own parameters, and the width that follows from them where none is given.
void read_parameters(const JsonFields& fields, LobeParameters& lobe) {
    const ModelInfo& info = model_info(lobe.model);
    for (const ModelParameter& parameter : info.parameters) {
        const NumberRange range{parameter.min, parameter.max};
        const Color3f value = parameter.per_channel ? fields.color(parameter.name, range, Color3f(parameter.value))
                                                    : Color3f(fields.number(parameter.name, range, parameter.value));
        lobe.extra.insert(lobe.extra.end(), {value.x, value.y, value.z});
        if (!parameter.per_channel) lobe.extra.resize(lobe.extra.size() - 2);
    }
    if (const float own_width = prepare(lobe); own_width > 0 && !names_width(fields)) lobe.mx = lobe.my = own_width;
}

/// What lobes take from their material: the model where they name none, the diffuse part, the tables that were read.
struct Surroundings {
    ModelId model;
    Color3f kd;
    TableFiles& tables;
};

LobeParameters lobe_from_json(const JsonFields& fields, const Surroundings& material) {
    LobeParameters lobe;
    lobe.model = model_from_json(fields, material.model);
    fields.expect_at_most_one(std::array<std::string_view, 2>{"ks", "kt"});
    lobe.side = fields.has("kt") ? Side::transmission : Side::reflection;
    lobe.strength = fields.number(fields.has("kt") ? "kt" : "ks", kStrength, 1);
    lobe.tint = fields.color("tint", kStrength, Color3f(1));
    const Vec2f widths = widths_from_json(fields);
    lobe.mx = widths.x, lobe.my = widths.y;
    lobe.rotation = static_cast<float>(fields.number("rotation_deg", {-360, 360}, 0) * kDegree);
    lobe.fresnel = fresnel_from_json(fields);
    lobe.fresnel.complement = lobe.side == Side::transmission && lobe.fresnel.kind != FresnelKind::none;
    table_from_json(fields, lobe, material.kd, material.tables);
    read_parameters(fields, lobe);
    if (!names_width(fields)) take_table_widths(lobe);
    lobe.per_pixel = per_pixel_from_json(fields);
    if (const ModelInfo& info = model_info(lobe.model); !info.anisotropic && lobe.is_anisotropic())
        throw Error(ErrorCode::bad_argument, fields.path("model") + ": " + std::string(info.name) +
                                                 " is a round lobe; give it one width m, or take another model");
    return lobe;
}

void fresnel_to_json(const Fresnel& fresnel, json& lobe) {
    switch (fresnel.kind) {
        case FresnelKind::none: break;
        case FresnelKind::schlick: lobe["r0"] = to_json_color(fresnel.eta); break;
        case FresnelKind::generalised_schlick:
            lobe["r0"] = to_json_color(fresnel.eta);
            lobe["f1"] = to_json_color(fresnel.k);
            break;
        case FresnelKind::lazanyi:
            lobe["r0"] = to_json_color(fresnel.eta);
            lobe["dip"] = to_json_color(fresnel.k);
            lobe["dip_power"] = to_json_number(fresnel.power);
            break;
        case FresnelKind::dielectric: lobe["ior"] = to_json_number(fresnel.eta.x); break;
        case FresnelKind::conductor:
            lobe["eta"] = to_json_color(fresnel.eta);
            lobe["k"] = to_json_color(fresnel.k);
            break;
    }
}

json lobe_to_json(const LobeParameters& lobe) {
    const ModelInfo& info = model_info(lobe.model);
    json result{{"model", info.name},
                {lobe.side == Side::transmission ? "kt" : "ks", to_json_number(lobe.strength)},
                {"tint", to_json_color(lobe.tint)},
                {"mx", to_json_number(lobe.mx)},
                {"my", to_json_number(lobe.my)}};
    if (lobe.rotation != 0) result["rotation_deg"] = to_json_number(static_cast<float>(lobe.rotation / kDegree));
    fresnel_to_json(lobe.fresnel, result);
    const std::vector<float> values = lobe.extra.empty() ? default_parameters(info) : lobe.extra;
    const float* value = values.data();
    for (const ModelParameter& parameter : info.parameters) {
        result[std::string(parameter.name)] =
            parameter.per_channel ? to_json_color(Color3f(value[0], value[1], value[2])) : to_json_number(*value);
        value += parameter.per_channel ? 3 : 1;
    }
    if (const std::string table = table_of(lobe); !table.empty()) result["table"] = table;
    for (const PerPixelName& entry : kPerPixel)
        if (lobe.per_pixel.*entry.flag) result["per_pixel"].push_back(entry.name);
    return result;
}

std::vector<LobeParameters> lobes_from_json(const JsonFields& material, const Surroundings& own) {
    material.expect_only(std::array<std::string_view, 4>{"model", "kd", "kd_coupled", "lobes"});
    const json& list = material.at("lobes");
    if (!list.is_array()) fail_expected(material.path("lobes"), "a list of lobes [{...}]", list);
    std::vector<LobeParameters> lobes;
    for (size_t i = 0; i < list.size(); ++i) {
        const JsonFields lobe(list[i], material.path("lobes[" + std::to_string(i) + "]"));
        lobe.expect_only(lobe_keys(model_info(model_from_json(lobe, own.model))));
        lobes.push_back(lobe_from_json(lobe, own));
    }
    return lobes;
}

LobeParameters single_lobe_from_json(const JsonFields& material, const Surroundings& own) {
    Names known = lobe_keys(model_info(own.model));
    known.insert(known.end(), {"kd", "kd_coupled", "lobes"});
    material.expect_only(known);
    return lobe_from_json(material, own);
}

}  // namespace

Material material_from_json(const json& value, const std::string& name, const std::string& where) {
    const JsonFields fields(value, where);
    if (value.empty()) fail_expected(where, "a lobe, \"lobes\" or \"kd\"", value);
    Material material;
    material.name = name;
    TableFiles tables;
    material.kd = kd_from_json(value, fields, kReflectivity, tables);
    const Surroundings own{model_from_json(fields, ModelId::kurt), material.kd, tables};
    material.kd_coupled = fields.boolean("kd_coupled", false);
    const bool only_diffuse = fields.has("kd") && value.size() == (fields.has("kd_coupled") ? 2 : 1);
    if (fields.has("lobes"))
        material.lobes = lobes_from_json(fields, own);
    else if (!only_diffuse)
        material.lobes = {single_lobe_from_json(fields, own)};
    return material;
}

json material_to_json(const Material& material) {
    json lobes = json::array();
    for (const LobeParameters& lobe : material.lobes) lobes.push_back(lobe_to_json(lobe));
    json value = {{"kd", to_json_color(material.kd)}, {"lobes", lobes}};
    if (material.kd_coupled) value["kd_coupled"] = true;
    return value;
}

}  // namespace burnish
