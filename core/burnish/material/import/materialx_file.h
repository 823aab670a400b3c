// The materials of a MaterialX file: standard_surface and open_pbr_surface, their constants as their definitions say they reflect.
#pragma once

#include <burnish/material/parameters.h>

#include <string>
#include <vector>

namespace burnish {

/// See read_materials; named by their material nodes, by the shader's own name where no material wears it.
std::vector<Material> materialx_materials(const std::string& file);

}  // namespace burnish
