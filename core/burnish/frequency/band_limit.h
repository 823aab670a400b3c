// From the strength of wavelet bands to one frequency: up to where the spectrum still matters.
//
// Band k holds the frequencies from 2^-(k+2) to 2^-(k+1) cycles per sample, and some of its neighbours', since the wavelets'
// spectra overlap. Within the band where the limit is found it lies at
//
//     2^-(k+1) sqrt u,   u = E_k / (E_k + E_(k+1)),
//
// about half an octave above the frequency of a pure wave and a quarter below that of noise that fills the band.
#pragma once

#include <span>

namespace burnish {

/// Both published rules (Bandwidth IV.3.1). `energy`: the given quantile of the energy, from low to high (figure IV.5).
/// `maxima`: below the finest bands whose largest coefficients add up to less than epsilon of the largest of all (eq. IV.3);
/// the top of the band. The first is the default: the second finds the highest frequency there is in nearly every picture,
/// because so much of a low wave leaks into the finest band of wavelets with four taps (tests/test_bandwidth.py).
enum class BandRule { energy, maxima };

/// Cycles per sample, in [0, 0.5]. `energies` from the finest band on, the last entry is what lies below all bands; `constant` is
/// the energy at frequency zero, as far as it counts. A band is compared with the finer ones and the `octaves` next coarser.
float energy_band_limit(std::span<const float> energies, float constant, float quantile, int octaves);

/// The same from the bands' largest squared coefficients, all octaves.
float maxima_band_limit(std::span<const float> squares, float constant, float epsilon);

}  // namespace burnish
