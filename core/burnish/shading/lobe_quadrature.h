// A lobe as the fit sees it: its values on a few hundred directions that lie as densely as the lobe is bright.
//
// The directions are mirror images of wo at microfacet normals on a polar grid of normalised slopes, so the grid follows
// the lobe through every roughness, anisotropy and view: what is a circle in slopes is the lobe's own stretched shape here.
// Directions below the horizon belong to it, with value 0: a fit has to know where light must not leak in.
//
// Light is hardly ever sharper than a degree, so detail of the lobe finer than that need not be fitted: the lobe is blurred a
// little, and the Gaussians are fitted as blurred by as much. Long thin lobes gain most (docs/measured.md).
#pragma once

#include <burnish/material/parameters.h>

#include <array>
#include <vector>

namespace burnish {

/// Entry j of all lists is one direction.
struct LobeQuadrature {
    std::vector<float> x, y, z;               // wi, local frame, unit, mirrored above the surface for transmission lobes
    std::vector<float> root_area;             // square root of the solid angle it stands for
    std::array<std::vector<float>, 3> value;  // f |cos theta_i|, RGB, blurred, without tint and strength
    Color3f albedo;                           // integral of f |cos theta_i|
    float blur;                               // rad, width of the Gaussian it is blurred by
    float farthest;                           // slope: taps beyond it see nothing of the lobe
    float finest;                             // rad: narrower detail would fall between the directions

    size_t size() const { return x.size(); }
};

/// The lobe (its mx, my as given) from wo (local, wo.z > 0). `half`: only y >= 0, of twice the area, for lobes and views that
/// are symmetric about the plane y = 0. `taps`: how many Gaussians it is to be fitted by, which sets the blur.
LobeQuadrature lobe_quadrature(const LobeParameters& lobe, const Vec3f& wo, bool half, int taps);

}  // namespace burnish
