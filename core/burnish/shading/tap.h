// One filtered lookup of an estimator. Every few-sample estimator is linear in the light,
//
//     L = sum of weight_i * stack(wi_i, level_i),
//
// so all it has to say at a point is a list of taps: what the light holds comes later, and how it is read is one kernel.
#pragma once

#include <burnish/base/types.h>

#include <algorithm>

namespace burnish {

inline constexpr float kHardEdge = 1e6f;     // taps that end at the horizon
inline constexpr float kLeastShare = 0.05f;  // keeps the share of taps that lie below both horizons

/// A lookup in the local frame of a lobe. A tap below the horizon keeps its direction and weighs nothing, so that taps
/// change smoothly with the view and can be interpolated.
struct Tap {
    Vec3f wi{0, 0, 1};        // any length
    float level = 0;          // of the stack, without the distortion of the cube's faces; any finite number
    Color3f weight{0, 0, 0};  // everything the light is multiplied by
    float edge = kHardEdge;   // how fast it fades where the geometric surface hides it: 1 / sine of the angle it takes
};

/// What the taps of a lobe come to. Fits may have taps of negative weight; where such a one meets a lamp that its neighbours just
/// miss the sum is below zero, which no reflection is.
inline Color3f reflected(const Color3f& sum) { return {std::max(sum.x, 0.0f), std::max(sum.y, 0.0f), std::max(sum.z, 0.0f)}; }

/// Share of a tap that the geometric surface leaves of what the shading surface leaves, 1 where both are one. A wide tap fades
/// while it sets: share(x) = 1/2 + x edge / 2 in [0, 1]; one with a hard edge is there or not. above_n, above_ng: cosines of
/// wi to both normals.
inline float visible_share(float above_n, float above_ng, float edge) {
    const auto share = [&](float x) { return std::min(std::max(0.5f + 0.5f * x * edge, 0.0f), 1.0f); };
    const float n = edge < kHardEdge / 2 ? share(above_n) : 1.0f, hidden = (n - share(above_ng)) / std::max(n, kLeastShare);
    return std::min(std::max(1 - hidden, 0.0f), 1.0f);
}

}  // namespace burnish
