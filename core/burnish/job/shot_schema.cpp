// The shot file's JSON schema (draft 2020-12), one property per row of the settings table.
#include <burnish/job/light_schema.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>

#include <cmath>

namespace burnish {
namespace {

using nlohmann::json;

void add_range(json& schema, const Setting& setting) {
    if (std::isfinite(setting.range.min)) schema["minimum"] = setting.range.min;
    if (std::isfinite(setting.range.max)) schema["maximum"] = setting.range.max;
}

json triple() { return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}}; }

/// Names of lights: "floor,sky" or a list.
json chain_schema() { return {{"anyOf", {{{"type", "string"}}, {{"type", "array"}, {"items", {{"type", "string"}}}}}}}; }

json rule_schema() {
    const auto says = [](json schema, const char* words) {
        schema["description"] = words;
        return schema;
    };
    const json id = {{"type", "integer"}, {"minimum", 0}}, text = {{"type", "string"}};
    const json fields = {{"material", says(text, "name of a material, as of the setting material")},
                         {"index", says(id, "object id of the pixels")},
                         {"material_index", says(id, "material id of the pixels")},
                         {"cryptomatte", says(text, "name in a cryptomatte, with wildcards * and ?")},
                         {"light", says(chain_schema(), "the lights they see, the one in front first")}};
    const json object = {
        {"type", "object"}, {"properties", fields}, {"required", {"material"}}, {"additionalProperties", false}};
    return {{"type", "array"}, {"items", {{"anyOf", {text, object}}}}};
}

json value_schema(const Setting& setting) {
    json schema;
    switch (setting.kind) {
        case SettingKind::boolean: schema["type"] = "boolean"; break;
        case SettingKind::integer: schema["type"] = "integer", add_range(schema, setting); break;
        case SettingKind::number: schema["type"] = "number", add_range(schema, setting); break;
        case SettingKind::text:
        case SettingKind::path: schema["type"] = "string"; break;
        case SettingKind::choice: schema["enum"] = setting.choices; break;
        case SettingKind::names: schema = {{"type", "array"}, {"items", {{"enum", setting.choices}}}}; break;
        case SettingKind::color: schema["anyOf"] = {triple(), {{"type", "number"}}}; break;
        case SettingKind::vector: schema = triple(); break;
        case SettingKind::pairs: schema = {{"type", "object"}, {"additionalProperties", {{"type", "string"}}}}; break;
        case SettingKind::rules: schema = rule_schema(); break;
        case SettingKind::lights: schema["type"] = "object"; break;
        case SettingKind::materials:
            schema = {{"type", "object"}, {"additionalProperties", {{"type", {"object", "string"}}}}};
            break;
    }
    if (setting.name == "camera") schema["type"] = {"string", "object"};
    if (setting.name == "default_light") schema = chain_schema();
    schema["description"] =
        setting.unit.empty() ? std::string(setting.help) : std::string(setting.help) + " (" + std::string(setting.unit) + ")";
    schema["default"] = setting.default_value();
    return schema;
}

json object_schema(json properties) {
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

/// A light in its place, or the file that it is in.
json any_light(json environment) {
    std::vector<json> forms = light_schemas();
    forms.insert(forms.begin(), {std::move(environment), {{"type", "string"}}});
    return {{"anyOf", forms}};
}

}  // namespace

json shot_schema() {
    json document = {{"$schema", {{"type", "string"}}}}, sections;
    for (const Setting& setting : settings()) {
        json& properties = setting.section.empty() ? document : sections[std::string(setting.section)];
        properties[std::string(setting.key)] = value_schema(setting);
    }
    sections["lights"]["type"] = {{"const", "environment"}};
    for (auto& [name, properties] : sections.items()) {
        json section = object_schema(properties);
        if (name == "lights")
            document[name]["additionalProperties"] = any_light(std::move(section));
        else
            document[name] = std::move(section);
    }
    json schema = object_schema(document);
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    schema["title"] = "burnish shot file";
    return schema;
}

}  // namespace burnish
