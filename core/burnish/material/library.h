// Materials by name and by file: the built-in presets and JSON.
#pragma once

#include <burnish/material/parameters.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// The built-in presets ("chrome", "gold", "car-paint", ...), sorted by name.
std::span<const Material> presets();

/// A material from JSON; `where` is the path to the field for messages, e.g. "shot.json: materials.brass".
/// Unknown keys, wrong types and numbers out of range throw Error(bad_argument) naming field, expected, found and nearest name.
Material material_from_json(const nlohmann::json& json, const std::string& name, const std::string& where);
nlohmann::json material_to_json(const Material& material);

/// A material by what a user types: a preset's name, "merl:NAME" (measured_library.h), the path of a JSON file holding one material,
/// whose tables are relative to its folder, a material of another program's file (import_material.h), or the path of a measurement
/// (read_measured.h).
Material find_material(const std::string& name_or_file);

}  // namespace burnish
