// A lobe as the fit sees it: its values on a few hundred directions that lie as densely as the lobe is bright.
//
// The directions are mirror images of wo at microfacet normals on a polar grid of normalised slopes, so the grid follows
// the lobe through every roughness, anisotropy and view: what is a circle in slopes is the lobe's own stretched shape here.
// Directions below the horizon belong to it, with value 0: a fit has to know where light must not leak in.
#pragma once

#include <burnish/material/parameters.h>

#include <Eigen/Core>

namespace burnish {

/// Entry j of all arrays is one direction.
struct LobeQuadrature {
    Eigen::ArrayXf x, y, z;            // wi, local frame, unit, mirrored above the surface for transmission lobes
    Eigen::ArrayXf root_area;          // square root of the solid angle it stands for
    Eigen::Array<float, -1, 3> value;  // f |cos theta_i|, RGB, without tint and strength
    Color3f albedo;                    // integral of `value`
    float blur = 0;   // rad
    float farthest;                    // slope: what lies beyond is not seen by the lobe
    float finest;                      // rad: narrower detail would fall between the directions
};

/// d reflect(wo, h) / d sx and d sy at h ~ (sx, sy, 1).
struct DirectionSlopes {
    Vec3f x, y;
};
DirectionSlopes direction_slopes(const Vec3f& wo, float sx, float sy);

/// The lobe (its mx, my as given) from wo (local, wo.z > 0). `half`: only y >= 0, of twice the area, for lobes and views that
/// are symmetric about the plane y = 0.
LobeQuadrature lobe_quadrature(const LobeParameters& lobe, const Vec3f& wo, bool half);

}  // namespace burnish
