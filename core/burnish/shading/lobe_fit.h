// A lobe as Gaussians over a path of views: every view starts from its neighbour's fit, so that taps move smoothly and a
// table of them can be interpolated.
#pragma once

#include <burnish/shading/gaussian_fit.h>

#include <span>
#include <vector>

namespace burnish {

using GaussianTaps = std::vector<GaussianTap>;

/// The fit from one view, from `near` if that is not empty, else the best of a few starts (line_probes of several lengths).
/// in_plane: lobe and view are symmetric about y = 0.
GaussianTaps fit_view(const LobeParameters& lobe, const Vec3f& wo, bool in_plane, int taps, const GaussianTaps& near);

/// Fits of all `views`, outwards from views[anchor], whose fit is `start`.
std::vector<GaussianTaps> fit_path(const LobeParameters& lobe, std::span<const Vec3f> views, bool in_plane, size_t anchor,
                                   const GaussianTaps& start);

/// Tap by tap, `part` of the way from a to b.
GaussianTaps blend(const GaussianTaps& a, const GaussianTaps& b, float part);

/// Paths that fit_best_path tries.
inline constexpr int kPathStarts = 5;

/// fit_path from each of the starts that fit_view knows; the one whose taps, interpolated half way between the views, are nearest
/// to the lobe. What looks best from one view may jump at another.
std::vector<GaussianTaps> fit_best_path(const LobeParameters& lobe, std::span<const Vec3f> views, bool in_plane, size_t anchor,
                                        int taps);

}  // namespace burnish
