// Published fits of measured materials by name: "merl:brass" and 99 more, see merl_sgd.json. Parsed when first asked for, one
// material at a time, so that those who never ask pay nothing.
#pragma once

#include <burnish/material/parameters.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// "merl:alum-bronze", ..., sorted.
std::span<const std::string> library_names();

/// Whether it begins with the name of a library, "merl:".
bool is_library_name(std::string_view name);

/// A material of the library as its JSON. Throws Error(bad_argument) with the nearest names.
const nlohmann::json& library_json(const std::string& name);
Material library_material(const std::string& name);

}  // namespace burnish
