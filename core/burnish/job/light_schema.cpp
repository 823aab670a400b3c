#include <burnish/job/light_schema.h>

#include <burnish/light/light_json.h>

#include <algorithm>
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

struct FieldWords {
    std::string_view name, says;
};

// Lengths are scene units, places are world space.
constexpr FieldWords kFieldWords[] = {
    {"type", "what kind of light it is"},
    {"file", "its picture; a cube map in six files has %s in the name, a mirror may have ####"},
    {"centre", "where the cube map was taken"},
    {"depth", "picture or six pictures with distances; left out: channels Z or Depth.Z of the file"},
    {"distances", "what they measure: planar, along the axis of the face, or ray, from the centre"},
    {"convention", "how a lat-long picture lies over directions"},
    {"up", "up axis of the render's world"},
    {"rotate", "degrees that the picture is turned by about the up axis"},
    {"proxy", "what stands for the room where rays end: infinite, the map's depth, planes, a box or a mesh"},
    {"camera", "camera of the picture; left out: the frame's, mirrored for a mirror"},
    {"plane", "plane of the mirror or pane"},
    {"behind", "the picture shows what lies behind a pane"},
    {"second_step", "meet the surface that the first guess found once more: sharper, a little slower"},
    {"corners", "of a convex polygon, three or more, counter-clockwise on its bright side"},
    {"radiance",
     "of an area light: a number or R, G, B; of a traced scene: light map of what leaves the surfaces, emission included"},
    {"texture", "picture that multiplies the radiance; its lower left corner lies at the first corner"},
    {"two_sided", "shines to both sides"},
    {"scene", "glTF or OBJ file of the room"},
    {"irradiance", "light map of irradiance / pi, to be multiplied by the albedo"},
    {"albedo", "map of diffuse reflectance; left out: the materials' base colours"},
    {"texcoord", "set of texture coordinates that the maps lie over"},
    {"rays", "that a lookup's cone is averaged from"},
    {"scale", "multiplies the light"},
    {"tint", "colour that multiplies the light"},
    {"space", "colour space of its pictures; left out: the frame's"},
    {"blocks", "hides what comes behind it in a list of lights"}};

/// What is not listed is a path or a name.
std::map<std::string_view, json> field_values() {
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

/// What a field may hold, and what it says.
json field_schema(const std::map<std::string_view, json>& values, std::string_view field) {
    json schema = values.contains(field) ? values.at(field) : json{{"type", "string"}};
    schema["description"] = std::ranges::find(kFieldWords, field, &FieldWords::name)->says;
    return schema;
}

}  // namespace

std::vector<json> light_schemas() {
    const std::map<std::string_view, json> values = field_values();
    const std::map<std::string_view, json> required = {{"cubemap", {"type", "file", "centre"}},
                                                       {"mirror", {"type", "file", "plane"}},
                                                       {"area", {"type", "corners"}},
                                                       {"traced", {"type", "scene"}}};
    std::vector<json> schemas;
    for (const std::string_view type : kNearLightTypes) {
        json properties;
        for (const std::string_view field : light_fields(type)) properties[std::string(field)] = field_schema(values, field);
        properties["type"]["const"] = type;
        properties["type"].erase("type");
        schemas.push_back(object_of(properties, required.at(type)));
    }
    return schemas;
}

}  // namespace burnish
