// What projections know of the material and of the light.
//
// A rough surface reflects on the whole in another direction than a mirror: nearer to the normal at most views, and away from the
// horizon, which cuts its lobe. Maps looked up by that direction are twice as exact (docs/measured.md). It stays in the plane of normal
// and view, so that for an isotropic material a curve over c = n . wo holds it:
//
//     r = normalize( towards_n(c) n + towards_r(c) (c n - wo) ),     of a mirror: towards_n = c, towards_r = 1
#pragma once

#include <burnish/base/types.h>

#include <array>

namespace burnish {

struct Material;

/// Unit vectors.
struct DirectionPair {
    Vec3f a, b;
};

struct FactorGuide {
    static constexpr int kKnots = 33;  // at even steps of c from 0 to 1, straight lines between

    Vec3f dominant{0, 0, 1};  // where most of the light comes from, unit, in the axes of the maps
    std::array<float, kKnots> towards_n, towards_r;

    /// That of a mirror.
    FactorGuide();
    /// Where the material's lobes reflect to on the whole: the mean of f cos(theta_i) wi over the sphere of wi, by luminance.
    static FactorGuide of(const Material& material);

    /// r of (n, wo), unit.
    Vec3f reflection(const DirectionPair& pair) const;
};

}  // namespace burnish
