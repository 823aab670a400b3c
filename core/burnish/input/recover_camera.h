// The camera of a frame whose header does not tell: recovered from which world point each pixel sees.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/camera.h>
#include <burnish/input/row_strips.h>

#include <optional>
#include <string>

namespace burnish {

/// Camera, lens shift included, that best explains the position layer (world space, 3 channels, holding `rows`).
///
/// Background, NaN and silhouettes are left out, up to 40 % wrong pixels are tolerated. Half-float positions give the centre to
/// about 1e-4 of the viewing distance, 32-bit ones to better than 1e-6.
///
/// valid    1 channel, > 0 where position holds; may be null
/// note     what was found, or why there is no camera and what to do
/// returns  nothing when the pixels do not determine a camera: too few of them, all on one plane, orthographic, panoramic
std::optional<Camera> recover_camera(const Image& position, const RowStrips& rows, const Window& display, const Image* valid,
                                     std::string& note);

}  // namespace burnish
