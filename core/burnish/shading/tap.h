// One filtered lookup of an estimator. Every few-sample estimator is linear in the light,
//
//     L = sum of weight_i * stack(wi_i, level_i),
//
// so all it has to say at a point is a list of taps: what the light holds comes later, and how it is read is one kernel.
#pragma once

#include <burnish/base/types.h>

namespace burnish {

/// A lookup in the local frame of a lobe. A tap below the horizon keeps its direction and weighs nothing, so that taps
/// change smoothly with the view and can be interpolated.
struct Tap {
    Vec3f wi{0, 0, 1};        // any length
    float level = 0;          // of the stack, without the distortion of the cube's faces; any finite number
    Color3f weight{0, 0, 0};  // everything the light is multiplied by
};

}  // namespace burnish
