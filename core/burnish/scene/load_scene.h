// Scenes from files: glTF 2.0 (.glb, .gltf) and OBJ.
#pragma once

#include <burnish/base/up_axis.h>
#include <burnish/scene/scene.h>

#include <string>

namespace burnish {

struct SceneSettings {
    UpAxis up = UpAxis::automatic;  // of the world to load into; automatic counts as y. OBJ files are in its axes already
    int texcoord = 0;               // which set of texture coordinates a mesh brings to Vertex::uv, v up
};

/// One object for every mesh of every node, in the file's order, where its node stands. Normals are those of the faces where the
/// file has none, tangents follow u. Albedo is the material's base colour without its texture, emission the emissive colour times
/// its strength. Object and material indices are the `pass_index` of glTF's extras, else counted from 1. Meshes without texture
/// coordinates have uv 0. Throws Error(read_failed) for files that are damaged, too large or hold no triangles, and
/// Error(bad_argument) when a mesh lacks the set of texture coordinates that was asked for, other than the first.
Scene load_scene(const std::string& file, const SceneSettings& settings = {});

}  // namespace burnish
