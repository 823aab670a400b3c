// Where the fit of a lobe begins: a short line of equal Gaussians along the lobe's longer axis.
//
// The line runs along the longer axis of the lobe's image (lobe_image.h), each Gaussian as wide as the shorter one: what
// `probes` are elsewhere, and what the fit improves.
#pragma once

#include <burnish/shading/gaussian_fit.h>

namespace burnish {

/// `taps` Gaussians for the lobe's widths (mx, my) seen from wo. `reach` is half the line's length in standard deviations of
/// the lobe; `spread` > 1 makes every second one wider by that factor, for lobes with a long tail.
std::vector<GaussianTap> line_probes(const Vec3f& wo, float mx, float my, int taps, float reach, float spread);

}  // namespace burnish
