// The materials of a glTF 2.0 file: metallic-roughness with KHR_materials_ior, _specular, _anisotropy, _clearcoat and _transmission, as
// their specifications say they reflect.
#pragma once

#include <burnish/material/parameters.h>

#include <string>
#include <vector>

namespace burnish {

/// See read_materials; one without a name is called by its place, "material_3".
std::vector<Material> gltf_materials(const std::string& file);

}  // namespace burnish
