// The six faces of a cube map: which direction a place on a face is, and which texel lies beyond an edge.
//
// Axes and faces are OpenEXR's (see cube_pyramid.h): every face is seen from inside, so right = forward x up.
#pragma once

#include <burnish/base/types.h>

#include <algorithm>

namespace burnish {

/// Face index and position in the face, x right and y down in [0, 1]^2.
struct CubeCoord {
    int face;
    float x, y;
};

/// A texel of one face.
struct CubeTexel {
    int face, x, y;
};

/// Axes of a face as coordinate index and sign: the face's forward axis is face / 2, negative for odd faces.
struct CubeFaceAxes {
    int right;
    float right_sign;
    int up;
    float up_sign;
};
inline constexpr CubeFaceAxes kCubeFaces[6] = {{2, 1, 1, 1},  {2, -1, 1, 1}, {0, 1, 2, 1},
                                               {0, 1, 2, -1}, {0, -1, 1, 1}, {0, 1, 1, 1}};

/// A vector given along a face's (forward, right, up) axes, and back.
inline Vec3f face_to_cube(int face, const Vec3f& v) {
    const CubeFaceAxes& axes = kCubeFaces[face];
    Vec3f d;
    d[face / 2] = face % 2 ? -v.x : v.x;
    d[axes.right] = axes.right_sign * v.y;
    d[axes.up] = axes.up_sign * v.z;
    return d;
}
inline Vec3f cube_to_face(int face, const Vec3f& d) {
    const CubeFaceAxes& axes = kCubeFaces[face];
    return {face % 2 ? -d[face / 2] : d[face / 2], axes.right_sign * d[axes.right], axes.up_sign * d[axes.up]};
}

/// Where a texel centre lies on the cube [-1, 1]^3, along its face's axes: (1, right, up).
inline Vec3f face_place(int x, int y, int size) {
    const auto along = [&](int i) { return static_cast<float>(2 * i + 1 - size) / static_cast<float>(size); };
    return {1.0f, along(x), -along(y)};
}

/// Where direction d (any length) meets the cube. A zero or non-finite d gives some place inside [0, 1]^2.
inline CubeCoord cube_coord(const Vec3f& d) {
    const float ax = std::fabs(d.x), ay = std::fabs(d.y), az = std::fabs(d.z);
    const int axis = ax >= ay ? (ax >= az ? 0 : 2) : (ay >= az ? 1 : 2);
    const int face = 2 * axis + (d[axis] < 0.0f);
    const CubeFaceAxes& axes = kCubeFaces[face];
    const float half = 0.5f / std::fabs(d[axis]);
    const float x = 0.5f + axes.right_sign * d[axes.right] * half, y = 0.5f - axes.up_sign * d[axes.up] * half;
    return {face, std::min(std::max(0.0f, x), 1.0f), std::min(std::max(0.0f, y), 1.0f)};
}

/// log2(|d| / max |d_k|): how much further than its centre a place on the face is away, in octaves; 0 to 0.79.
inline float cube_distortion(const Vec3f& d) {
    const float largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    return 0.5f * std::log2(d.length2() / (largest * largest));
}

/// The unit direction through a place on a face: the inverse of `cube_coord`.
Vec3f cube_direction(int face, float x, float y);

/// The texel that lies at (x, y) of a face with `size` texels a side when the neighbouring faces are unfolded around it:
/// one of x and y may be outside [0, size), by up to `size` texels.
CubeTexel unfolded_texel(int face, int x, int y, int size);

/// Solid angle of [x0, x1] x [y0, y1] on a face of the cube [-1, 1]^3, steradian.
double cube_solid_angle(double x0, double x1, double y0, double y1);

}  // namespace burnish
