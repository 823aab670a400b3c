// The wavelet transform with four taps (Daubechies 1988): orthonormal, two vanishing moments, 3 cells wide.
//
//     low_j  = sum_k h_k s_(2j+k),   h = (1 + r, 3 + r, 3 - r, 1 - r) / (4 sqrt 2),   r = sqrt 3
//     high_j = sum_k g_k s_(2j+k),   g_k = (-1)^k h_(3-k)
//
// In two dimensions rows and columns take turns: each step splits an image into four of half its size, of which the next step
// splits the one that is low both ways. Indices wrap around; surround the signal where that is not meant.
#pragma once

#include <burnish/base/image.h>

namespace burnish {

inline constexpr float kDaubechiesLow[4] = {0.48296291f, 0.83651630f, 0.22414387f, -0.12940952f};
inline constexpr float kDaubechiesHigh[4] = {-0.12940952f, -0.22414387f, 0.83651630f, -0.48296291f};

/// The coefficients of `bands` steps, in the signal's size and energy: band 0, the finest, fills the right half and the bottom
/// half, band 1 the same of the upper left quarter that is left, and so on; what is low in every band ends up in the corner.
/// Width and height must be multiples of 2^bands, one channel. Throws Error(size_mismatch).
Image daubechies(const Image& signal, int bands);

/// The signal that has these coefficients.
Image inverse_daubechies(const Image& coefficients, int bands);

}  // namespace burnish
