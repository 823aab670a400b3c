// Materials of other programs by file: glTF (.gltf, .glb) and MaterialX (.mtlx), their constants as lobes. What has no place in a lobe,
// textures above all, is left out and told.
//
//     car.gltf#paint     a material of a file by name; "car.gltf" alone where there is one only
#pragma once

#include <burnish/material/parameters.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace burnish {

/// Whether a text names a file that `read_materials` reads, by its ending; "#name" behind it does not matter.
bool is_import_name(const std::string& text);

/// All materials of a file, in its order, with what was left out in Material::notes. Colours are as in the file: linear Rec.709.
/// Throws Error(read_failed) for what cannot be read and Error(bad_argument) for numbers out of range, with the path to the field.
std::vector<Material> read_materials(const std::string& file);

/// The same as [{"name", "material", "notes"}], with materials as burnish's JSON has them. Bytes that are not UTF-8 are replaced.
nlohmann::json materials_json(const std::string& file);

/// The one material that "file#name" or "file" means. Throws as read_materials, and Error(bad_argument) that lists the names.
Material import_material(const std::string& text);

}  // namespace burnish
