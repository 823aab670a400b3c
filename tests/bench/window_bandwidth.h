// Bandwidth as a picture really has it: windowed Fourier transforms, what predictions are measured against (Bandwidth IV.5.1).
#pragma once

#include <burnish/base/image.h>

#include <vector>

namespace burnish {

/// One window of 32 x 32 pixels.
struct PictureWindow {
    static constexpr int kSize = 32;
    int x, y;         // its first pixel
    float bandwidth;  // cycles per pixel: below it lie 95 % of the energy, the mean apart; no finer than 2 / 32
};

/// All windows `stride` pixels apart whose pixels are all in `mask`, of a picture of one channel.
std::vector<PictureWindow> window_bandwidths(const Image& picture, const Image& mask, int stride);

/// shading_level of a bandwidth, but no coarser than 3, all that such a window resolves.
float windowed_level(float cycles_per_pixel);

/// Mean of a channel over a window, weighted like its transform.
float window_mean(const Image& picture, const PictureWindow& window);

}  // namespace burnish
