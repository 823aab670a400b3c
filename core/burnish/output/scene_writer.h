// A scene to a file that load_scene, and any modeller, reads: binary glTF.
#pragma once

#include <burnish/base/up_axis.h>
#include <burnish/scene/scene.h>

#include <string>

namespace burnish {

/// Writes a .glb: a node and a mesh an object, with normals, texture coordinates and triangles; materials with base colour,
/// emission, roughness; object and material indices as `pass_index` of extras. glTF has Y up: with `up` z the scene is turned, as
/// load_scene turns it back. Whole or not at all. Throws Error(write_failed | bad_argument).
void write_scene(const std::string& file, const Scene& scene, UpAxis up);

}  // namespace burnish
