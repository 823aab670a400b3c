// Normals and tangents of meshes that came without.
#pragma once

#include <burnish/scene/mesh.h>

namespace burnish {

/// Gives each triangle corners of its own with the triangle's normal.
void set_face_normals(Mesh& mesh);

/// Sets the tangents from how texture coordinates run over the triangles about each vertex; any direction where they do not vary.
/// Normals must be unit vectors.
void set_tangents(Mesh& mesh);

}  // namespace burnish
