// Regular sample patterns over a lobe: where the few filtered lookups of the `regular` estimator go.
//
// A pattern lives in normalised slope space: a sample (u, v) stands for the microfacet normal with slopes
// (mx u, my v), h = (mx u, my v, 1) / |.|, so one layout serves a lobe at every roughness. Circles are laid out as for a Gaussian
// lobe, exp(-w^2) (Beckmann, Kurt); other lobes stretch the radius so that equal shares of energy lie within equal
// circles, and a long tail gets more circles of fewer samples.
#pragma once

#include <burnish/sampling/estimator.h>

#include <functional>
#include <vector>

namespace burnish {

struct PatternSample {
    float u, v;        // normalised slopes
    float area;        // of the (u, v) plane the lookup is filtered over; those of a regular pattern tile the lobe
    float weight = 1;  // area this sample stands for in the sum, relative to `area`
};
using LobePattern = std::vector<PatternSample>;

/// Normalised slope beyond which the share xi of a lobe's energy lies (`LobeModel::border`).
using RadiusOf = std::function<float(float xi)>;
/// sqrt(-ln xi): Beckmann's and Kurt's.
float gaussian_radius(float xi);

/// Equally spaced concentric circles (Regular 5) filling the lobe up to its border, Gaussian radius w = sqrt(-ln border).
///
/// With a sample at the centre the first circle holds `first` samples (6 in the source) at w = s; without, `first` (4)
/// at s/sqrt(2). Circle i holds 2 floor(first q_i / (2 q_1) + 1/2) samples, q = r / (dr/dw) being the circle's length in
/// units of its spacing. For Gaussian lobes q_i ~ w_i, the source's rule: three circles (the centre counted) give 19 and 30.
/// Anisotropic lobes, `aspect` = mx/my != 1: circles about the wider axis; samples beyond the border are dropped, and each circle
/// is turned by half a step if that keeps the larger sum of densities.
/// border  xi0, share of the lobe's energy beyond the border, in (0, 1); for Gaussian lobes also the density there
///         relative to the peak, as the source has it.
LobePattern circle_pattern(int circles, int first, bool centred, float aspect, float border, const RadiusOf& radius_of);

/// One sample at the centre and n - 1 on a ring at 40 % of the border's energy, xi = 0.6 (Walkthrough 4.4.3). n >= 2.
LobePattern ring_pattern(int n, float border, const RadiusOf& radius_of);

/// One sample at the centre, the others shared out to about as many rings as each has samples, each turned against the one within:
/// dense near the centre, so that a depth edge fades in gently as it moves through the lobe (Walkthrough 4.5.3: 10 samples,
/// three rings of three). n >= 2.
LobePattern rings_pattern(int n, float border, const RadiusOf& radius_of);

/// n equally spaced samples along the wider axis, for strongly anisotropic lobes (Walkthrough 4.4.3). n >= 1.
LobePattern line_pattern(int n, float aspect, float border, const RadiusOf& radius_of);

/// What `automatic` stands for: `tuned` where that measured better and no border is given, as tuned patterns have none; else a
/// line for very long lobes, else circles of either spacing (`automatic` still). Other kinds stand for themselves.
PatternKind chosen_kind(PatternKind kind, int samples, float aspect, float border);

/// The pattern of `kind` whose count is nearest to `samples`, for a lobe of these widths; circles try both spacings and a few
/// first circles. Tuned patterns depend on mx and my, all others on mx/my alone. border = 0 takes the measured default for the
/// count, `default_border`.
LobePattern regular_pattern(PatternKind kind, int samples, float mx, float my, float border, const RadiusOf& radius_of);

/// xi0 for n samples, between what measured best on stress lights with rough lobes and on a real HDR with smooth ones
/// (docs/measured.md). A long tail, as of GGX, holds energy that only samples far out see, and wants a lower border.
float default_border(int samples, const RadiusOf& radius_of);

}  // namespace burnish
