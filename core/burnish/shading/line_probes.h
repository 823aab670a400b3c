// Where the fit of a lobe begins: a short line of equal Gaussians along the lobe's longer axis.
//
// To first order the lobe is the image of the slopes' Gaussian under reflection. With J = d reflect(wo, h) / d(sx, sy) at the
// mirror direction (2 in the plane of incidence, 2 cos theta_o across it) and M = diag(mx^2, my^2) / 2 the slopes' covariance,
// the image has covariance J M J^T: its longer axis is the line, its shorter one the Gaussians' width. Anisotropic materials
// are included: the axis turns with the view.
#pragma once

#include <burnish/shading/gaussian_fit.h>

namespace burnish {

/// `taps` Gaussians for the lobe's widths (mx, my) seen from wo. `reach` is half the line's length in standard deviations of
/// the lobe; `spread` > 1 makes every second one wider by that factor, for lobes with a long tail.
std::vector<GaussianTap> line_probes(const Vec3f& wo, float mx, float my, int taps, float reach, float spread);

}  // namespace burnish
