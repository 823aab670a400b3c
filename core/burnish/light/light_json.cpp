#include <burnish/light/light_json.h>

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/light/cube_map/proxy_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

using nlohmann::json;
using Names = std::vector<std::string_view>;

constexpr double kLargest = 1e9;
constexpr NumberRange kRadiance{0, kLargest}, kDegrees{-360000, 360000};

constexpr std::array<std::string_view, 13> kCubeMapFields{"type",   "file",  "depth", "distances", "centre", "convention", "up",
                                                          "rotate", "proxy", "scale", "tint",      "space",  "blocks"};
constexpr std::array<std::string_view, 10> kMirrorFields{"type",        "file",  "camera", "plane", "behind",
                                                         "second_step", "scale", "tint",   "space", "blocks"};
constexpr std::array<std::string_view, 9> kAreaFields{"type",  "corners", "radiance", "texture", "two_sided",
                                                      "scale", "tint",    "space",    "blocks"};
constexpr std::array<std::string_view, 12> kTracedFields{"type", "scene",    "radiance", "irradiance", "albedo", "up",
                                                         "rays", "texcoord", "scale",    "tint",       "space",  "blocks"};

std::string required_text(const JsonFields& fields, std::string_view key, const std::string& what) {
    const std::string text = fields.text(key);
    if (text.empty()) throw Error(ErrorCode::bad_argument, fields.path(key) + ": missing; name " + what);
    return text;
}

template <class E, size_t n>
E choice(const JsonFields& fields, std::string_view key, const std::pair<std::string_view, E> (&values)[n], E fallback) {
    if (!fields.has(key)) return fallback;
    Names names;
    for (const auto& value : values) names.push_back(value.first);
    return std::ranges::find(values, fields.name(key, names), &std::pair<std::string_view, E>::first)->second;
}

template <class E, size_t n>
std::string_view name_of(E value, const std::pair<std::string_view, E> (&values)[n]) {
    return std::ranges::find(values, value, &std::pair<std::string_view, E>::second)->first;
}

/// Adds a field that is not at its default.
void put(json& value, const char* key, const std::string& text) {
    if (!text.empty()) value[key] = text;
}

CubeMapSettings cube_map_from_json(const JsonFields& fields) {
    CubeMapSettings map;
    map.file = required_text(fields, "file", "the picture, or six of them by %s in the name");
    map.depth = fields.text("depth");
    map.distances = choice(fields, "distances", kDistanceNames, DistanceKind::automatic);
    map.centre = fields.vector("centre");
    map.picture.convention = choice(fields, "convention", kConventionNames, EnvironmentConvention::automatic);
    map.picture.up = choice(fields, "up", kUpNames, UpAxis::automatic);
    map.picture.rotate_deg = fields.number("rotate", kDegrees, 0);
    if (fields.has("proxy")) map.proxy = proxy_from_json(fields.at("proxy"), fields.path("proxy"));
    return map;
}

void put(json& value, const CubeMapSettings& map) {
    value["file"] = map.file, value["centre"] = to_json_vector(map.centre);
    put(value, "depth", map.depth);
    if (map.distances != DistanceKind::automatic) value["distances"] = name_of(map.distances, kDistanceNames);
    if (map.picture.convention != EnvironmentConvention::automatic)
        value["convention"] = name_of(map.picture.convention, kConventionNames);
    if (map.picture.up != UpAxis::automatic) value["up"] = name_of(map.picture.up, kUpNames);
    if (map.picture.rotate_deg != 0) value["rotate"] = to_json_number(map.picture.rotate_deg);
    if (map.proxy.kind != ProxyKind::infinite) value["proxy"] = proxy_to_json(map.proxy);
}

MirrorSettings mirror_from_json(const JsonFields& fields) {
    MirrorSettings mirror;
    mirror.file = required_text(fields, "file", "the EXR of what the mirror shows");
    const bool is_object = fields.has("camera") && fields.at("camera").is_object();
    mirror.camera = is_object ? fields.at("camera").dump() : fields.text("camera");
    mirror.plane = plane_from_json(fields.at("plane"), fields.path("plane"));
    mirror.behind = fields.boolean("behind", false);
    mirror.second_step = fields.boolean("second_step", true);
    return mirror;
}

void put(json& value, const MirrorSettings& mirror) {
    value["file"] = mirror.file, value["plane"] = plane_to_json(mirror.plane);
    if (mirror.camera.starts_with('{'))
        value["camera"] = json::parse(mirror.camera);
    else
        put(value, "camera", mirror.camera);
    if (mirror.behind) value["behind"] = true;
    if (!mirror.second_step) value["second_step"] = false;
}

AreaSettings area_from_json(const JsonFields& fields) {
    AreaSettings area;
    const json& corners = fields.at("corners");
    const std::string where = fields.path("corners");
    if (!corners.is_array() || corners.size() < 3) fail_expected(where, "a list of three or more places [x, y, z]", corners);
    for (size_t i = 0; i < corners.size(); ++i)
        area.corners.push_back(vector_from_json(corners[i], where + "[" + std::to_string(i) + "]"));
    area.radiance = fields.color("radiance", kRadiance, area.radiance);
    area.texture = fields.text("texture");
    area.two_sided = fields.boolean("two_sided", false);
    return area;
}

void put(json& value, const AreaSettings& area) {
    value["corners"] = json::array();
    for (const Vec3f& corner : area.corners) value["corners"].push_back(to_json_vector(corner));
    value["radiance"] = to_json_color(area.radiance);
    put(value, "texture", area.texture);
    if (area.two_sided) value["two_sided"] = true;
}

TracedSettings traced_from_json(const JsonFields& fields) {
    TracedSettings traced;
    traced.scene = required_text(fields, "scene", "a glTF or OBJ file");
    traced.radiance = fields.text("radiance"), traced.irradiance = fields.text("irradiance");
    traced.albedo = fields.text("albedo");
    traced.up = choice(fields, "up", kUpNames, UpAxis::automatic);
    traced.texcoord = fields.whole_number("texcoord", {0, 15}, 0);
    traced.rays = fields.whole_number("rays", {1, 64}, traced.rays);
    return traced;
}

void put(json& value, const TracedSettings& traced) {
    value["scene"] = traced.scene;
    put(value, "radiance", traced.radiance), put(value, "irradiance", traced.irradiance);
    put(value, "albedo", traced.albedo);
    if (traced.up != UpAxis::automatic) value["up"] = name_of(traced.up, kUpNames);
    if (traced.texcoord != 0) value["texcoord"] = traced.texcoord;
    if (traced.rays != TracedSettings().rays) value["rays"] = traced.rays;
}

/// Lamps are thin: what is behind them is seen beside them.
bool blocks_by_itself(const LightSettings& light) { return !std::holds_alternative<AreaSettings>(light.kind); }

void visit_files(CubeMapSettings& map, const auto& visit) { visit(map.file), visit(map.depth), visit(map.proxy.mesh); }
void visit_files(MirrorSettings& mirror, const auto& visit) {
    visit(mirror.file);
    if (!mirror.camera.starts_with('{')) visit(mirror.camera);
}
void visit_files(AreaSettings& area, const auto& visit) { visit(area.texture); }
void visit_files(TracedSettings& traced, const auto& visit) {
    visit(traced.scene), visit(traced.radiance), visit(traced.irradiance), visit(traced.albedo);
}

}  // namespace

std::span<const std::string_view> light_fields(std::string_view type) {
    if (type == "cubemap") return kCubeMapFields;
    if (type == "mirror") return kMirrorFields;
    return type == "area" ? std::span<const std::string_view>(kAreaFields) : kTracedFields;
}

LightSettings light_from_json(const json& value, const std::string& where) {
    const JsonFields fields(value, where);
    const std::string type = fields.name("type", kNearLightTypes);
    fields.expect_only(light_fields(type));
    LightSettings light;
    if (type == "cubemap")
        light.kind = cube_map_from_json(fields);
    else if (type == "mirror")
        light.kind = mirror_from_json(fields);
    else if (type == "area")
        light.kind = area_from_json(fields);
    else
        light.kind = traced_from_json(fields);
    light.scale = fields.number("scale", kRadiance, 1);
    light.tint = fields.color("tint", kRadiance, light.tint);
    light.space = fields.text("space");
    light.blocks = fields.boolean("blocks", blocks_by_itself(light));
    return light;
}

json light_to_json(const LightSettings& light) {
    json value = {{"type", kNearLightTypes[light.kind.index()]}};
    std::visit([&](const auto& kind) { put(value, kind); }, light.kind);
    if (light.scale != 1) value["scale"] = to_json_number(light.scale);
    if (light.tint != Color3f(1, 1, 1)) value["tint"] = to_json_color(light.tint);
    put(value, "space", light.space);
    if (light.blocks != blocks_by_itself(light)) value["blocks"] = light.blocks;
    return value;
}

void for_each_file(LightSettings& light, const std::function<void(std::string&)>& visit) {
    const auto named = [&](std::string& file) {
        if (!file.empty()) visit(file);
    };
    std::visit([&](auto& kind) { visit_files(kind, named); }, light.kind);
}

}  // namespace burnish
