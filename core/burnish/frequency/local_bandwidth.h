// How fast an image varies around each of its pixels (Bandwidth IV.3.1): what its wavelets say, in cycles per sample.
//
// Wavelets are local in space and in frequency, so the coefficients of those that cover a pixel are its local spectrum.
#pragma once

#include <burnish/base/image.h>
#include <burnish/frequency/band_limit.h>

namespace burnish {

/// What lies around an image. `zero`: nothing, its border is an edge (area lights; the same as padding to twice the size and
/// cropping); `repeat`: itself again (tiling textures); `latlong`: itself left and right, over the poles above and below.
enum class Surround { zero, repeat, latlong };

struct BandwidthSettings {
    BandRule rule = BandRule::energy;
    float quantile = 0.95f;   // of the energy
    int octaves = 3;          // that a band may be coarser and compete: wider wavelets reach for what is elsewhere
    float epsilon = 0.01f;    // of the largest coefficient
    float contrast = 0.005f;  // variation that, relative to the local value, competes with the image's own
    Surround surround = Surround::zero;
};

/// Local bandwidth of a one-channel image at each pixel, cycles per sample, in [0, 0.5]. Throws Error(size_mismatch).
Image local_bandwidth(const Image& image, const BandwidthSettings& settings);

/// The same of a texture `width` x `height` units of length large, cycles per unit.
Image spatial_bandwidth(const Image& image, float width, float height, const BandwidthSettings& settings);

/// Steps of the pyramid for an image whose shorter side is `size`: until eight to fifteen cells are left.
int band_count(int size);
/// Texels that an image must be surrounded with, so that no wavelet that counts at a pixel wraps around.
constexpr int surround_width(int bands) { return 2 << bands; }

/// The same of an image that has its surroundings, `surround_width(bands)` texels at least left and above, and to the next
/// multiple of 2^bands right and below; returns the width x height pixels inside. `surround` does not count.
Image surrounded_bandwidth(const Image& surrounded, int width, int height, int bands, const BandwidthSettings& settings);

}  // namespace burnish
