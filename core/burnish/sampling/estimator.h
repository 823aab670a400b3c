// Which estimator of the overlay integral, and its knobs. Names are the ones of the command line and the shot file.
#pragma once

#include <string>

namespace burnish {

/// `fitted`: a few Gaussians fitted to the lobe, but `regular` where those do not do (see MaterialShader); `regular`: the
/// sources' patterns; `filtered_importance`: Colbert & Krivanek; `preconvolved`: Bandwidth IV.3.5;
/// `split_sum`: one prefiltered lookup, as real-time engines do; `factored`: a product of two to four maps made beforehand, for all
/// lobes and lamps together; `reference`: converges to the exact integral.
enum class EstimatorKind { fitted, regular, filtered_importance, preconvolved, split_sum, factored, reference };

/// Shapes of the `regular` pattern: `circles` = equally spaced circles (Regular 5), `offset_circles` = the same without a
/// sample at the centre, `ring` = 1 + one ring, `rings` = 1 + a few sparse ones, `line` = along the elongation, `tuned` = fitted to lights, 3 to 30
/// samples; `automatic` = tuned where it measured better, else circles, or a line when max(mx/my, my/mx) is extreme.
enum class PatternKind { automatic, circles, offset_circles, ring, rings, line, tuned };

/// `half_vector`: constant density of half vectors (Regular 17-18); `energy`: Walkthrough 4.24; `energy_squared`: 4.25.
enum class Quadrature { half_vector, energy, energy_squared };

struct EstimatorSettings {
    EstimatorKind kind = EstimatorKind::fitted;
    int samples = 0;  // lookups per lobe, 0 = by estimator (lookup_count); `regular` takes the pattern nearest to it
    bool adaptive =
        false;  // fewer lookups where the light varies little inside the lobe, `samples` at the most (sample_ladder.h);
                // regular, filtered_importance, preconvolved; reference: where its first look at its error is
    PatternKind pattern = PatternKind::automatic;
    float border = 0.0f;  // xi0: the lobe ends where this share of its energy lies beyond, (0, 1); 0 = by sample count
    Quadrature quadrature = Quadrature::half_vector;
    float level_bias = -0.9f;             // MIP levels added to the footprint rule (regular, filtered_importance)
    bool albedo_correction = true;        // tabulated true / estimated albedo, the cure for grazing angles
    float tolerance = 0.005f;             // reference: stop at this standard error, relative to the pixel's mean
    int max_samples = 16384;              // reference: sample cap per pixel
    std::string parametrization = "nre";  // factored: of the maps, one of lighting (factor/parametrization.h)
    int map_size = 32;                    // factored: texels a side of a map's discs
};

inline constexpr int kMostFitted = 16;  // lookups: beyond it a fit gains nothing

/// Lookups per lobe and pixel of a few-sample estimator; adaptive: the most of a pixel, by default twice as many.
inline int lookup_count(const EstimatorSettings& settings) {
    if (settings.kind == EstimatorKind::split_sum || settings.kind == EstimatorKind::factored) return 1;
    const bool fitted = settings.kind == EstimatorKind::fitted, preconvolved = settings.kind == EstimatorKind::preconvolved;
    const int by_estimator = fitted ? 6 : preconvolved ? 32 : 19;
    const int count = settings.samples > 0 ? settings.samples : settings.adaptive && !fitted ? by_estimator * 2 : by_estimator;
    return fitted && count > kMostFitted ? kMostFitted : count;
}

}  // namespace burnish
