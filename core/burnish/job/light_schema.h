// JSON schemas of the lights near the objects, for the shot file's.
#pragma once

#include <nlohmann/json.hpp>

namespace burnish {

/// One schema a type, as light_json.h reads it.
std::vector<nlohmann::json> light_schemas();

}  // namespace burnish
