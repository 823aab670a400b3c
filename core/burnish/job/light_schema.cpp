#include <burnish/job/light_schema.h>

#include <burnish/light/light_json.h>

#include <map>

namespace burnish {
namespace {

using nlohmann::json;

json object_of(const json& properties, const json& required) {
    return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

json list_of(const json& items, int least) { return {{"type", "array"}, {"items", items}, {"minItems", least}}; }

template <class E, size_t n>
json names_of(const std::pair<std::string_view, E> (&values)[n]) {
    json names = json::array();
    for (const auto& value : values) names.push_back(value.first);
    return {{"enum", names}};
}

json proxy_schema(const json& triple, const json& plane) {
    const json corner_box = object_of({{"min", triple}, {"max", triple}}, {"min", "max"});
    const json turned_box =
        object_of({{"centre", triple}, {"half", triple}, {"x", triple}, {"y", triple}, {"z", triple}}, {"centre", "half"});
    return {{"anyOf",
             {{{"enum", {"infinite", "depth"}}},
              object_of({{"planes", list_of(plane, 1)}}, {"planes"}),
              object_of({{"box", {{"anyOf", {corner_box, turned_box}}}}}, {"box"}),
              object_of({{"mesh", {{"type", "string"}}}}, {"mesh"})}}};
}

/// What is not listed is a path or a name.
std::map<std::string_view, json> field_schemas() {
    const json number = {{"type", "number"}}, boolean = {{"type", "boolean"}};
    json triple = list_of(number, 3);
    triple["maxItems"] = 3;
    const json plane = object_of({{"point", triple}, {"normal", triple}}, {"point", "normal"});
    const json color = {{"anyOf", {triple, number}}};
    return {{"centre", triple},
            {"distances", names_of(kDistanceNames)},
            {"rays", {{"type", "integer"}, {"minimum", 1}, {"maximum", 64}}},
            {"texcoord", {{"type", "integer"}, {"minimum", 0}, {"maximum", 15}}},
            {"convention", names_of(kConventionNames)},
            {"up", names_of(kUpNames)},
            {"rotate", number},
            {"proxy", proxy_schema(triple, plane)},
            {"camera", {{"type", {"string", "object"}}}},
            {"plane", plane},
            {"behind", boolean},
            {"second_step", boolean},
            {"corners", list_of(triple, 3)},
            {"radiance", {{"anyOf", {triple, number, {{"type", "string"}}}}}},
            {"two_sided", boolean},
            {"scale", number},
            {"tint", color},
            {"blocks", boolean}};
}

}  // namespace

std::vector<json> light_schemas() {
    const std::map<std::string_view, json> known = field_schemas();
    const std::map<std::string_view, json> required = {{"cubemap", {"type", "file", "centre"}},
                                                       {"mirror", {"type", "file", "plane"}},
                                                       {"area", {"type", "corners"}},
                                                       {"traced", {"type", "scene"}}};
    std::vector<json> schemas;
    for (const std::string_view type : kNearLightTypes) {
        json properties;
        for (const std::string_view field : light_fields(type))
            properties[std::string(field)] = known.contains(field) ? known.at(field) : json{{"type", "string"}};
        properties["type"] = {{"const", type}};
        schemas.push_back(object_of(properties, required.at(type)));
    }
    return schemas;
}

}  // namespace burnish
