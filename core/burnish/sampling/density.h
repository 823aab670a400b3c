// How densely the image is shaded, and what decides it. Names are the ones of the command line and the shot file.
#pragma once

#include <burnish/sampling/estimator.h>

#include <cstddef>

namespace burnish {

/// `dense`: every pixel; `sparse`: as many as the predicted bandwidth asks for, the others are interpolated; `automatic`: sparse
/// where that pays (settled_density), and dense for `reference`, which others are compared with, and for `factored`, which costs less
/// than a prediction.
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

/// Whether some frame might be shaded sparsely.
inline bool may_be_sparse(ShadingDensity density, EstimatorKind estimator) {
    if (density != ShadingDensity::automatic) return density == ShadingDensity::sparse;
    return estimator != EstimatorKind::reference && estimator != EstimatorKind::factored;
}

/// What `automatic` comes to. Prediction has tables of its own to make, as dear as shading some million cheap pixels, and gains half of
/// the pixels: it pays for large frames, for many lookups a pixel, and under lights that are near. `pixels`: samples of the whole frame.
inline ShadingDensity settled_density(ShadingDensity density, const EstimatorSettings& estimator, size_t pixels, bool is_near) {
    constexpr size_t kManyPixels = 2'000'000;
    constexpr int kManyLookups = 32;
    if (density != ShadingDensity::automatic) return density;
    const bool pays = pixels >= kManyPixels || lookup_count(estimator) >= kManyLookups || is_near;
    return pays && may_be_sparse(density, estimator.kind) ? ShadingDensity::sparse : ShadingDensity::dense;
}

}  // namespace burnish
