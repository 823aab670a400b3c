// From bandwidth at the camera to where the image is shaded: cycles per pixel, the grid that these allow, and the pyramids that say
// how fine it has to be anywhere in a block of pixels (Bandwidth IV.3.3, IV.4.1).
//
// A grid of level L has a node every 2^L pixels. Nyquist asks for two nodes a cycle, 2^L <= 1 / (2 b), so
//
//     L = min(floor(log2(1 / (2 b))), floor(log2(min(W, H))))
//
// The source's equation IV.11 has 1 / b, although it asks for a rate of twice the bandwidth just before: taken with b as half the side
// of the spectrum it would leave out every second sample.
#pragma once

#include <burnish/base/image.h>

#include <vector>

namespace burnish {

/// b in cycles per pixel, >= 0, infinity included, to the level to shade at: whole, >= 0.
float shading_level(float cycles_per_pixel, int width, int height);

/// The image, then levels of half the size (rounded up) down to one pixel: each pixel the smallest or largest of the 2 x 2 it
/// covers, or of those of them that are in the image. Any channels, channel by channel.
std::vector<Image> min_pyramid(Image finest);
std::vector<Image> max_pyramid(Image finest);

}  // namespace burnish
