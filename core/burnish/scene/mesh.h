// Triangle meshes, and makers of the shapes a demo or a test needs: all by formula, Z up, with smooth normals, texture
// coordinates and tangents.
#pragma once

#include <burnish/base/types.h>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace burnish {

/// A point of a surface: position, unit normal to the outside, unit tangent dP/du (perpendicular to n) and uv in [0, 1]^2.
struct Vertex {
    Vec3f p, n, t;
    Vec2f uv;
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

/// A grid of columns x rows quads over the parameter square; `surface(u, v)` gives the vertex, dP/du x dP/dv pointing out.
Mesh make_surface(int columns, int rows, const std::function<Vertex(float u, float v)>& surface);

/// Sphere about the origin; the tangent runs along the parallels (the radial tangent about Z).
Mesh make_sphere(float radius, int segments);

/// Rectangle in the plane z = 0 about the origin, normal +Z, tangent +X.
Mesh make_plane(float half_x, float half_y);

/// Box about the origin whose edges and corners are rounded with radius `bevel`, in `steps` steps per quarter circle half.
Mesh make_box(const Vec3f& half, float bevel, int steps);

/// Surface of revolution about Z of a smooth curve (Catmull-Rom) through (radius, z) points: "vase", "bowl". The outside is to
/// the right of the direction in which the profile runs. `closed` joins the last point with the first. The tangent runs around
/// the axis, as brushing on a lathe does.
Mesh make_lathe(std::span<const Vec2f> profile, bool closed, int segments, int rows);

/// Tube of radius `tube` along the (p, q) torus knot of outer radius about `radius`; p = 1, q = 0 is a torus.
Mesh make_torus_knot(int p, int q, float radius, float tube, int segments, int sides);

/// Adds the part's triangles.
void append(Mesh& mesh, const Mesh& part);

/// The mesh moved by `m` (row vectors; must not mirror); normals and tangents follow.
Mesh transformed(Mesh mesh, const Matrix44f& m);

}  // namespace burnish
