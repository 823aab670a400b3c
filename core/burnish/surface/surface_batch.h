// What the shading kernels read: up to one tile of pixels of one material, as structure of arrays, so that a SIMD kernel
// can take the place of the scalar one without touching callers.
#pragma once

#include <burnish/base/types.h>

#include <cstdint>
#include <vector>

namespace burnish {

/// Three float planes of one vector field.
struct Vec3Planes {
    std::vector<float> x, y, z;

    void push_back(const Vec3f& v) { x.push_back(v.x), y.push_back(v.y), z.push_back(v.z); }
    Vec3f operator[](size_t i) const { return {x[i], y[i], z[i]}; }
    void clear() { x.clear(), y.clear(), z.clear(); }
};

/// The fields of a batch that not every reader needs.
struct BatchNeeds {
    bool position = true, tangent = true;
};

/// Pixels of one material, all valid: unit vectors, wo above both n and ng. World space, scene units.
/// Of size() are pixel, n and wo; p and t too, where they were asked for; ng and the fields from roughness on, where the
/// frame has such a layer. The others are empty.
struct SurfaceBatch {
    std::vector<uint32_t> pixel;    // flat index into the frame or band, row-major
    uint32_t band_start = 0;        // added to `pixel`: the same for a pixel whatever band it comes in
    Vec3Planes n, wo, p, t;         // t is perpendicular to n
    Vec3Planes ng;                  // empty: n is the geometric normal, too
    std::vector<float> roughness;   // slope width m (alpha), already squared from the artist's roughness; in (0, 1]
    std::vector<float> anisotropy;  // artist's anisotropy in [-1, 1]
    std::vector<float> rotation;    // radians, turns t about n, right-hand rule
    Vec3Planes tint;                // linear colour, multiplies the overlay
    std::vector<float> weight;      // multiplies the overlay

    size_t size() const { return pixel.size(); }
    const Vec3Planes& geometric_normal() const { return ng.x.empty() ? n : ng; }
    void clear();
};

}  // namespace burnish
