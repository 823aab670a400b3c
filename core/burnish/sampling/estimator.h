// Which estimator of the overlay integral, and its knobs. Names are the ones of the command line and the shot file.
#pragma once

namespace burnish {

enum class EstimatorKind { regular, filtered_importance, reference };

/// Shapes of the `regular` pattern: `circles` = equally spaced circles (Regular 5), `offset_circles` = the same without a
/// sample at the centre, `ring` = 1 + one ring, `line` = along the elongation, `tuned` = fitted to lights, 3 to 30
/// samples; `automatic` = tuned where it measured better, else circles, or a line when max(mx/my, my/mx) is extreme.
enum class PatternKind { automatic, circles, offset_circles, ring, line, tuned };

/// `half_vector`: constant density of half vectors (Regular 17-18); `energy`: Walkthrough 4.24; `energy_squared`: 4.25.
enum class Quadrature { half_vector, energy, energy_squared };

struct EstimatorSettings {
    EstimatorKind kind = EstimatorKind::regular;
    int samples = 19;  // lookups per lobe; `regular` takes the pattern nearest to it
    PatternKind pattern = PatternKind::automatic;
    float border = 0.0f;  // xi0: the lobe ends where this share of its energy lies beyond, (0, 1); 0 = by sample count
    Quadrature quadrature = Quadrature::half_vector;
    float level_bias = -0.9f;       // MIP levels added to the footprint rule
    bool albedo_correction = true;  // tabulated true / estimated albedo, the cure for grazing angles
    float tolerance = 0.005f;       // reference: stop at this standard error, relative to the pixel's mean
    int max_samples = 16384;        // reference: sample cap per pixel
};

}  // namespace burnish
