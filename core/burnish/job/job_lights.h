// The shot file's "lights": at most one environment, whose fields are settings of their own, and any number of lights near the
// objects (light_json.h), each under its name; and chains of such names, the light in front first.
#pragma once

#include <burnish/job/settings.h>

#include <filesystem>

namespace burnish {

/// What a chain is called that leaves the choice to assign_lights.h; no light may have this name.
inline constexpr std::string_view kAutomaticChain = "auto";

/// Sets all lights near the objects, and the environment if there is one, from {"name": {"type": ...}, ...}; a light may also be
/// the path of a JSON file or JSON text. Relative paths are taken from `folder`, those of a file from the file's.
/// Throws Error(bad_argument | read_failed).
void set_lights(Job& job, const nlohmann::json& lights, const std::string& where, const std::filesystem::path& folder = {});

/// A chain from "floor", "floor,sky" or ["floor", "sky"]. Throws Error(bad_argument).
std::vector<std::string> chain_from_json(const nlohmann::json& value, const std::string& where);
/// "floor,sky"
std::string chain_to_text(const std::vector<std::string>& chain);

namespace setting {
Setting lights_setting();
Setting chain_setting();
}  // namespace setting

}  // namespace burnish
