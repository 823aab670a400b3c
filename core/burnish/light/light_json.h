// Lights near the objects to and from JSON, the form of the shot file's "lights":
//
//     {"type": "cubemap", "file": "vase.%s.exr", "centre": [0, 0, 1], "proxy": {"box": {"min": [-3, -4, 0], "max": [3, 4, 3]}}}
//     {"type": "mirror", "file": "floor.####.exr", "plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}}
//     {"type": "area", "corners": [[-1, 0, 3], [-1, 1, 3], [1, 1, 3], [1, 0, 3]], "radiance": 12}
//     {"type": "traced", "scene": "room.glb", "radiance": "room_radiance.exr"}
//
// Every one may also have "scale", "tint", "space" and "blocks". The light that is far away is an environment, whose fields are
// settings of the job.
#pragma once

#include <burnish/light/light_settings.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace burnish {

/// The values of "type" in the order of LightSettings::kind.
inline constexpr std::string_view kNearLightTypes[] = {"cubemap", "mirror", "area", "traced"};

inline constexpr std::pair<std::string_view, EnvironmentConvention> kConventionNames[] = {
    {"auto", EnvironmentConvention::automatic},
    {"blender", EnvironmentConvention::blender},
    {"openexr", EnvironmentConvention::openexr}};
inline constexpr std::pair<std::string_view, DistanceKind> kDistanceNames[] = {
    {"auto", DistanceKind::automatic}, {"planar", DistanceKind::planar}, {"ray", DistanceKind::ray}};
inline constexpr std::pair<std::string_view, UpAxis> kUpNames[] = {
    {"auto", UpAxis::automatic}, {"y", UpAxis::y}, {"z", UpAxis::z}};

/// `where`: the path to `value` for messages, e.g. "shot.json: lights.floor". Throws Error(bad_argument) naming field, expected,
/// found and nearest name.
LightSettings light_from_json(const nlohmann::json& value, const std::string& where);
/// Fields at their defaults are left out.
nlohmann::json light_to_json(const LightSettings& light);

/// The fields that a light of this type may have, "type" among them.
std::span<const std::string_view> light_fields(std::string_view type);

/// Calls `visit` with every file that the light names; for those who must move them.
void for_each_file(LightSettings& light, const std::function<void(std::string& file)>& visit);

}  // namespace burnish
