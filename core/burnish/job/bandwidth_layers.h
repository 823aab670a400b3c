// What `burnish bandwidth` shows of a frame: the predicted bandwidth, and all that it is made of, as layers and pyramids.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/job.h>
#include <burnish/job/look.h>
#include <burnish/sampling/density.h>
#include <burnish/shading/predictor.h>
#include <burnish/shading/wavelet_prediction.h>

#include <string>
#include <vector>

namespace burnish {

/// Of one frame, one channel each. Pixels that are not shaded hold 0, and in `level` the coarsest one.
struct BandwidthLayers {
    Image bandwidth;  // of the overlay, cycles per pixel, at which two samples a cycle will do
    Image level;      // of the grid that is fine enough: a sample every 2^level pixels, see shading_level
    Image samples;    // per pixel for equal noise, by the predicted variance, relative to the mean over shaded pixels
    Image curvature;  // of the surface, 1/unit
    Image
        nu_a;  // of the overlay, cycles per radian of the reflected direction; `bandwidth` is this times the turn per pixel, shear included
    Image shaded;  // 1 where a pixel has a prediction
};

using Variances = std::vector<std::shared_ptr<const WaveletPrediction>>;

/// Of each material under the environment alone, which must outlive the result.
Variances prepare_variances(const std::vector<Material>& materials, const Environment& light, const DensitySettings& settings);

/// What predicts them: entry i for look i of a frame. A variance is null under other light: there it is not known, and `samples` is 1.
struct BandwidthLook {
    std::vector<BandwidthPredictor> predictors;
    Variances variances;
};

/// Of a whole frame. `samples` follows Bandwidth IV.9 where the light is sampled as it is (`reference`), else IV.10. Bit-identical for
/// any thread count. Throws Error(missing_channel | cancelled).
BandwidthLayers bandwidth_layers(const AovFrame& frame, const Assignment& assignment, const Surfaces& surfaces,
                                 const BandwidthLook& look, EstimatorKind estimator, const Progress& progress);

/// The layers with a pyramid each, as parts of one EXR: level_0 the frame, level_k every 2^k-th pixel the extreme of its block;
/// the smallest of `level`, the largest of the others. Metadata as of every output. Throws Error(write_failed).
void write_bandwidth(const std::string& file, const AovFrame& frame, const BandwidthLayers& layers, PixelType type,
                     const HeaderTexts& attributes = {});

/// The picture of `level`: each its colour (output/level_colors.h), black where nothing is shaded, the colours below as a scale.
Image level_picture(const BandwidthLayers& layers);

}  // namespace burnish
