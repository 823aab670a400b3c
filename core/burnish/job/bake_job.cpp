#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/job/bake_job.h>
#include <burnish/light/cube_map/proxy_json.h>
#include <burnish/light/light_json.h>

#include <nlohmann/json.hpp>

#include <array>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 12> kFields{"scene", "up",      "texcoord", "light_maps", "camera",  "size",
                                                   "cubes", "mirrors", "panes",    "cube_size",  "samples", "output"};
constexpr std::array<std::string_view, 5> kMapFields{"radiance", "irradiance", "albedo", "bake", "size"};
constexpr std::array<std::string_view, 3> kMapSources{"radiance", "irradiance", "bake"};
constexpr std::array<std::string_view, 3> kCubeFields{"object", "name", "centre"};
constexpr std::array<std::string_view, 4> kMirrorFields{"object", "name", "plane", "behind"};
constexpr std::array<std::string_view, 3> kUps{"auto", "y", "z"};
constexpr NumberRange kPictureSize{1, 65536}, kFaceSize{2, 8192}, kSamples{1, 4096}, kMapSize{16, 16384}, kSets{0, 7};

[[noreturn]] void refuse(const std::string& where, const std::string& problem) {
    throw Error(ErrorCode::bad_argument, where + ": " + problem);
}

int whole(const JsonFields& fields, std::string_view key, NumberRange range, int fallback) {
    const float value = fields.number(key, range, static_cast<float>(fallback));
    if (value != std::floor(value)) fail_expected(fields.path(key), "a whole number", fields.at(key));
    return static_cast<int>(value);
}

std::string file_from(const std::string& text, const std::filesystem::path& base) {
    return text.empty() || base.empty() ? text : (base / text).string();
}

/// The JSON itself, or a file.
std::string camera_from(const JsonFields& fields, const std::filesystem::path& base) {
    if (fields.at("camera").is_object()) return fields.at("camera").dump();
    const std::string camera = fields.text("camera");
    return camera.starts_with('{') ? camera : file_from(camera, base);
}

UpAxis up_from(const JsonFields& fields) {
    const std::string up = fields.name("up", kUps);
    return up == "z" ? UpAxis::z : up == "y" ? UpAxis::y : UpAxis::automatic;
}

CubeBake cube_from_json(const json& value, const std::string& where) {
    const JsonFields fields(value, where);
    fields.expect_only(kCubeFields);
    CubeBake cube{fields.text("object"), fields.text("name"), std::nullopt};
    if (fields.has("centre")) cube.centre = fields.vector("centre");
    if (cube.object.empty() && !cube.centre) refuse(where, "needs the object it is for, or a centre");
    if (cube.object.empty() && cube.name.empty()) refuse(where, "needs a name or an object");
    return cube;
}

MirrorBake mirror_from_json(const json& value, const std::string& where) {
    const JsonFields fields(value, where);
    fields.expect_only(kMirrorFields);
    MirrorBake mirror{fields.text("object"), fields.text("name"), std::nullopt, fields.boolean("behind", false)};
    if (fields.has("plane")) mirror.plane = plane_from_json(fields.at("plane"), fields.path("plane"));
    if (mirror.object.empty() && !mirror.plane) refuse(where, "needs the object that is the mirror, or a plane");
    if (mirror.object.empty() && mirror.name.empty()) refuse(where, "needs a name or an object");
    return mirror;
}

template <class Item>
std::vector<Item> list(const JsonFields& fields, std::string_view key, Item (*item)(const json&, const std::string&)) {
    std::vector<Item> items;
    if (!fields.has(key)) return items;
    const json& values = fields.at(key);
    if (!values.is_array()) fail_expected(fields.path(key), "a list of objects", values);
    for (size_t i = 0; i < values.size(); ++i)
        items.push_back(item(values[i], fields.path(key) + "[" + std::to_string(i) + "]"));
    return items;
}

void set_light_maps(BakeJob& job, const json& value, const std::string& where, const std::filesystem::path& base) {
    const JsonFields fields(value, where);
    fields.expect_only(kMapFields);
    fields.expect_at_most_one(kMapSources);
    job.radiance = file_from(fields.text("radiance"), base);
    job.irradiance = file_from(fields.text("irradiance"), base);
    job.albedo = file_from(fields.text("albedo"), base);
    job.bake_light_maps = fields.boolean("bake", false);
    job.light_map_size = whole(fields, "size", kMapSize, job.light_map_size);
}

void set_size(BakeJob& job, const json& value, const std::string& where) {
    const auto usable = [](const json& n) { return n.is_number_integer() && n >= kPictureSize.min && n <= kPictureSize.max; };
    if (!value.is_array() || value.size() != 2 || !usable(value[0]) || !usable(value[1]))
        fail_expected(where, "[width, height] in pixels, 1 to 65536", value);
    job.width = value[0], job.height = value[1];
}

}  // namespace

BakeJob bake_job_from_json(const json& document, const std::string& where, const std::filesystem::path& base) {
    const JsonFields fields(document, where);
    fields.expect_only(kFields);
    BakeJob job;
    job.scene = file_from(fields.text("scene"), base);
    if (job.scene.empty()) refuse(fields.path("scene"), "missing; name a glTF or OBJ file");
    if (fields.has("up")) job.up = up_from(fields);
    job.texcoord = whole(fields, "texcoord", kSets, 0);
    if (fields.has("light_maps")) set_light_maps(job, fields.at("light_maps"), fields.path("light_maps"), base);
    if (fields.has("camera")) job.camera = camera_from(fields, base);
    if (fields.has("size")) set_size(job, fields.at("size"), fields.path("size"));
    job.cubes = list(fields, "cubes", cube_from_json), job.mirrors = list(fields, "mirrors", mirror_from_json);
    job.panes = fields.text("panes");
    job.cube_size = whole(fields, "cube_size", kFaceSize, job.cube_size);
    job.samples = whole(fields, "samples", kSamples, job.samples);
    job.folder = file_from(fields.text("output"), base);
    if (job.folder.empty()) refuse(fields.path("output"), "missing; name the folder to write to");
    if (!job.mirrors.empty() && job.camera.empty()) refuse(fields.path("camera"), "missing; mirrors are baked for a camera");
    return job;
}

}  // namespace burnish
