// How far an image is from its reference: the measures every figure of burnish's accuracy is given in.
#pragma once

#include <burnish/base/image.h>

#include <cstddef>

namespace burnish {

/// All over the covered pixels and the first three channels (fewer where the images have fewer), b the reference.
struct Comparison {
    size_t pixels = 0;      // covered and finite in both images
    size_t non_finite = 0;  // covered, but NaN or infinite in one of them; in no other figure
    double reference_mean = 0;
    double display_psnr_db = 0;  // both scaled by 0.18 / reference_mean, clamped to [0, 1], sRGB-encoded, peak 1; infinite
                                 // for equal images
    double relative_rms = 0;     // sqrt(mean (a-b)^2) / reference_mean
    double rel_mse = 0;          // mean of (a-b)^2 / (b^2 + eps^2), eps = 0.01 reference_mean
    double largest_error = 0;    // of one channel, linear
    int largest_x = 0, largest_y = 0;
};

/// `mask`: 1 channel, > 0 covers; null covers all. Throws Error(size_mismatch) for images of different sizes, channels included.
Comparison compare_images(const Image& test, const Image& reference, const Image* mask);

/// Signed difference of luminance for the eye, 3 channels in [0, 1]: red where the test is brighter, blue where it is darker,
/// grey 0.5 where they agree. `gain` times the difference over the reference's mean fills the range at 1. Uncovered pixels are
/// black, non-finite ones magenta.
Image difference_image(const Image& test, const Image& reference, const Image* mask, float gain = 1);

}  // namespace burnish
