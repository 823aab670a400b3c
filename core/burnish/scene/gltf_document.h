// What a glTF file says in its JSON that Assimp does not tell, and what must be checked before Assimp may read it: it follows
// nested lists and chains of nodes by recursion.
#pragma once

#include <burnish/base/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burnish {

struct GltfMaterial {
    std::optional<int> pass_index;  // of its extras
    float emissive_strength = 1;    // KHR_materials_emissive_strength
};

/// Index from a number in untrusted extras; nothing when it is not one that a 32-bit float layer can hold.
std::optional<int> pass_index(double number);

/// The materials of a .glb or .gltf file, in its order. Throws Error(read_failed) for what is not glTF 2.0, is nested too deeply, has
/// nodes that are no forest, or asks for more vertices than burnish reads.
std::vector<GltfMaterial> read_gltf_materials(const std::string& file);

}  // namespace burnish
