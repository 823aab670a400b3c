#include <burnish/job/structured_settings.h>

#include <burnish/base/json_text.h>
#include <burnish/job/job_lights.h>
#include <burnish/job/setting_kinds.h>
#include <burnish/material/library.h>

#include <charconv>

namespace burnish::setting {
namespace {

using nlohmann::json;

constexpr std::pair<std::string_view, bool PerPixel::*> kPerPixel[] = {{"roughness", &PerPixel::roughness},
                                                                       {"anisotropy", &PerPixel::anisotropy},
                                                                       {"rotation", &PerPixel::rotation},
                                                                       {"tint", &PerPixel::tint},
                                                                       {"weight", &PerPixel::weight}};
constexpr std::string_view kRuleKeys[] = {"material", "index", "material_index", "cryptomatte", "light"};
constexpr NumberRange kAxisRange{-1e6, 1e6};
constexpr double kLargestId = 1 << 24;  // beyond it a float layer no longer tells ids apart

/// "gold", "gold=index:3", "gold=material:2" or "gold=crypto:table*" as the object form; "@floor,sky" behind it names its lights.
json rule_object(const std::string& given, const std::string& where) {
    const size_t at = given.rfind('@'), equals = given.find('=');
    const bool has_lights = at != std::string::npos && (equals == std::string::npos || at > equals);
    const std::string text = has_lights ? given.substr(0, at) : given;
    json rule = {{"material", text.substr(0, equals)}};
    if (has_lights) rule["light"] = given.substr(at + 1);
    if (equals == std::string::npos) return rule;
    const std::string selector = text.substr(equals + 1);
    const size_t colon = selector.find(':');
    const std::string kind = selector.substr(0, colon), value = colon == std::string::npos ? "" : selector.substr(colon + 1);
    int id = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), id);
    const bool whole = error == std::errc() && end == value.data() + value.size();
    if (kind == "index" && whole)
        rule["index"] = id;
    else if (kind == "material" && whole)
        rule["material_index"] = id;
    else if (kind == "crypto" && !value.empty())
        rule["cryptomatte"] = value;
    else
        throw Error(ErrorCode::bad_argument,
                    where + ": expected NAME=index:N, NAME=material:N or NAME=crypto:PATTERN, found '" + given + "'");
    return rule;
}

AssignRule rule_from_json(const json& value, const std::string& where) {
    if (value.is_string()) return rule_from_json(rule_object(value.get<std::string>(), where), where);
    if (!value.is_object()) fail_expected(where, "an object {\"material\": ..., \"index\": ...} or text", value);
    AssignRule rule;
    for (const auto& [key, field] : value.items()) {
        const std::string path = where + "." + key;
        if (key == "material")
            rule.material = checked_text(field, path);
        else if (key == "index")
            rule.object_index = static_cast<int>(checked_number(field, {0, kLargestId}, true, "", path));
        else if (key == "material_index")
            rule.material_index = static_cast<int>(checked_number(field, {0, kLargestId}, true, "", path));
        else if (key == "cryptomatte")
            rule.cryptomatte = checked_text(field, path);
        else if (key == "light")
            rule.chain = chain_from_json(field, path);
        else
            fail_unknown(where, "field", key, kRuleKeys);
    }
    if (rule.material.empty())
        throw Error(ErrorCode::bad_argument, where + ".material: missing; name a material, a preset, merl:NAME or a file");
    return rule;
}

json rule_to_json(const AssignRule& rule) {
    json value = {{"material", rule.material}};
    if (rule.object_index) value["index"] = *rule.object_index;
    if (rule.material_index) value["material_index"] = *rule.material_index;
    if (!rule.cryptomatte.empty()) value["cryptomatte"] = rule.cryptomatte;
    if (!rule.chain.empty()) value["light"] = rule.chain;
    return value;
}

json channels_to_json(const Job& job) {
    json value = json::object();
    for (const auto& [role, layer] : job.channels) value[std::string(role_info(role).name)] = layer;
    return value;
}

void set_channels(Job& job, const json& value, const std::string& where) {
    job.channels.clear();
    std::vector<std::string_view> names;
    for (const RoleInfo& info : roles()) names.push_back(info.name);
    for (const auto& [name, layer] : checked_pairs(value, where)) {
        if (std::find(names.begin(), names.end(), name) == names.end()) fail_unknown(where, "role", name, names);
        job.channels[role_by_name(name)] = layer;
    }
}

json camera_to_json(const Job& job) { return job.camera.starts_with('{') ? json::parse(job.camera) : json(job.camera); }

void set_camera(Job& job, const json& value, const std::string& where) {
    job.camera = value.is_object() ? value.dump() : checked_text(value, where);
    if (job.camera.starts_with('{')) parse_json(job.camera, where);
}

json materials_to_json(const Job& job) {
    json value = json::object();
    for (const auto& [name, material] : job.materials) value[name] = material_to_json(material);
    return value;
}

void set_materials(Job& job, const json& value, const std::string& where) {
    if (!value.is_object()) fail_expected(where, "an object {\"name\": material}", value);
    job.materials.clear();
    for (const auto& [name, field] : value.items()) {
        const bool named = field.is_string();
        Material material =
            named ? find_material(field.get<std::string>()) : material_from_json(field, name, where + "." + name);
        material.name = name;
        job.materials[name] = std::move(material);
    }
}

json assign_to_json(const Job& job) {
    json value = json::array();
    for (const AssignRule& rule : job.assign) value.push_back(rule_to_json(rule));
    return value;
}

void set_assign(Job& job, const json& value, const std::string& where) {
    if (!value.is_array()) fail_expected(where, "a list of rules", value);
    job.assign.clear();
    for (size_t i = 0; i < value.size(); ++i)
        job.assign.push_back(rule_from_json(value[i], where + "[" + std::to_string(i) + "]"));
}

json per_pixel_to_json(const Job& job) {
    json value = json::array();
    for (const auto& [name, member] : kPerPixel)
        if (job.per_pixel.*member) value.push_back(name);
    return value;
}

std::vector<std::string_view> per_pixel_names() {
    std::vector<std::string_view> names;
    for (const auto& entry : kPerPixel) names.push_back(entry.first);
    return names;
}

void set_per_pixel(Job& job, const json& value, const std::string& where) {
    if (!value.is_array()) fail_expected(where, "a list such as [\"roughness\", \"tint\"]", value);
    job.per_pixel = {};
    for (const json& name : value) job.per_pixel.*kPerPixel[checked_choice(name, per_pixel_names(), where)].second = true;
}

void set_tangent_axis(Job& job, const json& value, const std::string& where) {
    const Vec3f axis = checked_triple(value, kAxisRange, false, where);
    if (axis.length2() == 0) fail_expected(where, "a direction other than zero", value);
    job.surface.tangent_axis = axis;
}

}  // namespace

Setting channels_setting() {
    constexpr auto help = "layer that fills a role, where its name does not tell";
    return {"channel", "", "channels", SettingKind::pairs, "ROLE=LAYER", help, channels_to_json, set_channels};
}

Setting camera_setting() {
    constexpr auto help = "camera as JSON, a file or the text itself; empty: from the header or the position layer";
    return {"camera", "", "camera", SettingKind::path, "FILE", help, camera_to_json, set_camera};
}

Setting materials_setting() {
    constexpr auto help = "materials by name: lobes as JSON, a preset or a file";
    return {"materials", "", "materials", SettingKind::materials, "", help, materials_to_json, set_materials};
}

Setting assign_setting() {
    constexpr auto help =
        "material for some pixels: NAME=index:N (object id), NAME=material:N (material id), "
        "NAME=crypto:PATTERN; later rules win; @LIGHT,... behind it names the lights, the one in front first";
    return {"assign", "", "assign", SettingKind::rules, "NAME=SELECTOR", help, assign_to_json, set_assign};
}

Setting per_pixel_setting() {
    constexpr auto help = "numbers of the material that come from the frame's layers, pixel by pixel";
    constexpr auto kind = SettingKind::names;
    return {"per_pixel", "", "per_pixel", kind, "LIST", help, per_pixel_to_json, set_per_pixel, kAnyNumber, per_pixel_names()};
}

Setting tangent_axis_setting() {
    constexpr auto help = "world axis that brushing runs around, for tangent axis";
    const auto get = [](const Job& job) { return to_json_vector(job.surface.tangent_axis); };
    return {"tangent_axis", "surface", "tangent_axis", SettingKind::vector, "X,Y,Z", help, get, set_tangent_axis, kAxisRange};
}

}  // namespace burnish::setting
