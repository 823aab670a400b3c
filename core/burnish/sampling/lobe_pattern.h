// Regular sample patterns over a lobe: where the few filtered lookups of the `regular` estimator go.
//
// A pattern lives in normalised slope space: a sample (u, v) stands for the microfacet normal with slopes
// (mx u, my v), h = (mx u, my v, 1) / |.|, so one pattern serves a lobe at every roughness. Lobes whose slope density falls
// like exp(-r^2) (Beckmann, Kurt) use it as it is; others stretch the radius so that equal shares of energy lie within
// equal circles (`stretched`).
#pragma once

#include <burnish/sampling/estimator.h>

#include <functional>
#include <vector>

namespace burnish {

struct PatternSample {
    float u, v;      // normalised slopes
    float area;      // of the (u, v) plane this sample stands for; the areas of a pattern tile the lobe up to its border
};
using LobePattern = std::vector<PatternSample>;

/// Equally spaced concentric circles (Regular 5) filling the disc of radius sqrt(-ln border), the lobe's border.
///
/// With a sample at the centre the first circle holds `first` samples (6 in the source) at radius s; without, `first` (4)
/// at s/sqrt(2). Circle i holds 2 floor(first r_i / (2 r_1) + 1/2) samples: three circles (the centre counted) give 19 and 30.
/// Anisotropic lobes, `aspect` = mx/my != 1: circles about the wider axis; samples beyond the border are dropped, and each circle
/// is turned by half a step if that keeps the larger sum of densities.
/// border  xi0, density at the border relative to the peak, in (0, 1).
LobePattern circle_pattern(int circles, int first, bool centred, float aspect, float border);

/// One sample at the centre and n - 1 on a ring at 40 % of the border's energy, xi = 0.6 (Walkthrough 4.4.3). n >= 2.
LobePattern ring_pattern(int n, float border);

/// n equally spaced samples along the wider axis, for strongly anisotropic lobes (Walkthrough 4.4.3). n >= 1.
LobePattern line_pattern(int n, float aspect, float border);

/// The pattern of `kind` whose count is nearest to `samples`; circles try both spacings and first circles of 4 to 7.
/// border = 0 takes the measured default for the count, `default_border`.
LobePattern regular_pattern(PatternKind kind, int samples, float aspect, float border);

/// xi0 that measured best for isotropic Beckmann lobes with n samples (tests/bench tabulates it).
float default_border(int samples);

/// The pattern with its radii mapped by `radius_of`: xi -> normalised slope beyond which the share xi of the lobe's energy
/// lies (`LobeModel::border`); areas follow.
LobePattern stretched(const LobePattern& pattern, const std::function<float(float xi)>& radius_of);

}  // namespace burnish
