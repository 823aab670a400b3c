// How bright lights are on the whole: what exposes a prediction, before anything is shaded.
//
// The mean over all directions, as far as a light knows it by itself: no frame's pixels play a part, so that it is one number for
// a job, whatever bands and tiles its frames are shaded in. Predictions depend on it by its fourth root only.
#pragma once

#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/light_chain.h>

namespace burnish {

/// Of the radiance in the stack's widest level.
float mean_luminance(const GaussianStack& stack);

/// Of a room, whose lamps are few and bright: the square of the mean of square roots, as a display weighs them.
float display_mean_luminance(const CubeStack& stack);

/// Of a light, bright discs and lamps apart; 0 where it cannot say, as it has no mean without a place.
float mean_luminance(const Light& light);

/// Of a chain: of the darkest light that has one, as the others may be hidden; darker than it is makes predictions safer.
/// 0 where none has one.
float mean_luminance(const LightChain& lights);

}  // namespace burnish
