// Slopes of the half vector: the space where a lobe's widths mx, my live.
#pragma once

#include <burnish/material/lobes/microfacet.h>
#include <burnish/shading/shading_point.h>

#include <algorithm>

namespace burnish {

/// Of wo and the mirrored wi.
inline Vec2f half_slopes(const Vec3f& wo, const Vec3f& wi) {
    const Vec3f sum = wo + wi;
    return Vec2f(sum.x, sum.y) / std::max(sum.z, kMinCosine);
}

inline constexpr float kLowestSlope = 0.05f;  // cosine: lower directions have the slopes of those there

/// In units of the lobe's widths; wi mirrored above the surface.
inline Vec2f scaled_slopes(const ShadingPoint& point, const Vec3f& wi) {
    const Vec2f slope = half_slopes(point.wo, {wi.x, wi.y, std::max(wi.z, kLowestSlope)});
    return {slope.x / std::max(point.mx, kMinWidth), slope.y / std::max(point.my, kMinWidth)};
}

}  // namespace burnish
