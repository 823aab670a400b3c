// The JSON of a glTF 2.0 file, .gltf or .glb.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace burnish {

/// Throws Error(read_failed) for what is not glTF 2.0, too large, cut short or nested too deeply.
nlohmann::json read_gltf(const std::string& file);

}  // namespace burnish
