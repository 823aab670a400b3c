// What stands for the room around a cube map, to and from JSON: "infinite", "depth", {"planes": [{"point", "normal"}, ...]},
// {"box": {"min", "max"}}, {"box": {"centre", "half", "x", "y", "z"}} or {"mesh": "room.glb"}.
#pragma once

#include <burnish/light/light_settings.h>

#include <nlohmann/json_fwd.hpp>

namespace burnish {

/// `where`: the path to `value` for messages. Throw Error(bad_argument).
Plane plane_from_json(const nlohmann::json& value, const std::string& where);
ProxySettings proxy_from_json(const nlohmann::json& value, const std::string& where);

nlohmann::json plane_to_json(const Plane& plane);
nlohmann::json proxy_to_json(const ProxySettings& proxy);

}  // namespace burnish
