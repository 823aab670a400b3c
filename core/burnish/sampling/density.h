// How densely the image is shaded, and what decides it. Names are the ones of the command line and the shot file.
#pragma once

#include <burnish/sampling/estimator.h>

namespace burnish {

/// `dense`: every pixel; `sparse`: as many as the predicted bandwidth asks for, the others are interpolated; `automatic`: sparse,
/// but for `reference`, which others are compared with.
enum class ShadingDensity { automatic, dense, sparse };

/// Where the angular bandwidth of the overlay comes from. `curvature`: second derivative of the light once the lobe has filtered it;
/// `correlated`: wavelet bandwidths of light and lobe through the transport operators, space and angle clamped together;
/// `source`: the same as published (Bandwidth IV.4), where the light's own bandwidth survives a rough lobe.
enum class PredictionKind { curvature, correlated, source };

struct DensitySettings {
    ShadingDensity density = ShadingDensity::automatic;
    PredictionKind prediction = PredictionKind::curvature;
    int directions = 0;   // per lobe and prediction (n_b), 0 = by kind
    float safety = 2.0f;  // multiplies the predicted bandwidth: 1 keeps sparse within 45 dB of dense on the validation set; 2
                          // within 52, so that it flickers no more than dense
};

inline bool is_sparse(ShadingDensity density, EstimatorKind estimator) {
    return density == ShadingDensity::automatic ? estimator != EstimatorKind::reference : density == ShadingDensity::sparse;
}

}  // namespace burnish
