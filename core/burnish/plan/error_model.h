// How exact a configuration is expected to be, from how exact another was under the same light.
//
// How hard a light is moves all configurations together, by up to 15 dB; their distances to one another under the same light move by
// 1 to 3. So one cheap probe is measured and the others are predicted from it: by the class of lobe (the tail of its slopes, its width,
// how long it is), from a table that burnish_error_table measures over lights and materials (plan/error_table.json).
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/plan/configuration.h>

namespace burnish {

/// dB of display PSNR.
struct PredictedGain {
    float mean = 0;
    float deviation = 0;  // standard deviation over lights
};

/// Of `configuration` over kProbe, for this lobe. Per-pixel widths count as the lobe's own.
PredictedGain predicted_gain(const LobeParameters& lobe, const Configuration& configuration);

/// dB to dense shading that sparse shading keeps at this safety: the mean over smooth surfaces, and its deviation.
PredictedGain predicted_sparse(float safety);

}  // namespace burnish
