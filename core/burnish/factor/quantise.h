// Factors in 8 bits a channel, for engines that take nothing finer:
//
//     f(a, b) = white * min( c * product over j of rgb_k(j) * z, 1 ) * product over j of alpha_k(j)            (Factor 48, 51, 57)
//
// or, of several terms, the sum of such products, each with its own white, c and z.
//
// Maps are divided by their peaks and multiplied by prescale factors s_k, which lift dark texels off the steps of 8 bits and cut peaks
// off; the colour c takes it all back: s_0 times the product of s_k^f(k) is 1. z, a power of two, is what hardware that clamps at 1 in
// between can still multiply by. Alpha holds what is left of a texel when its colour has been made as bright as it may be without
// meeting the clamp earlier, so that dark texels keep their precision.
#pragma once

#include <burnish/factor/factors.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

struct QuantiseSettings {
    std::vector<float> weights;  // w_0 of the colour, w_k of map k, above 0; only their proportions count; empty = all 1
    float white = 0;             // the largest value that there can be; 0 = 1/z of what the peaks of all maps make together
    float scale = 1;             // z: 1, 2, 4, 8 or 16; of no use where white is given, which tells it
    bool alpha = true;           // without: for engines whose alpha is taken
};

struct QuantisedMap {
    DirectionMap layout;
    std::vector<std::array<uint8_t, 4>> texels;  // R, G, B, alpha; 255 is 1
};

struct QuantisedTerm {
    std::vector<QuantisedMap> maps;
    std::vector<float> prescale;  // s_0 of the colour, s_k of map k
    float white = 1;
    Color3f color{1, 1, 1};  // c, 0 to 1
    float scale = 1;         // z
};

struct QuantisedFactors {
    const Parametrization* parametrization = nullptr;
    FactorGuide guide;
    std::vector<QuantisedTerm> terms;

    Color3f operator()(const DirectionPair& pair) const;
};

/// `settings`: of each term, or of all. The few texels of several terms that are below zero become 0. Throws Error(bad_argument) for
/// maps that live by texels below zero, and for settings that cannot be.
QuantisedFactors quantise(const Factors& factors, std::span<const QuantiseSettings> settings);
inline QuantisedFactors quantise(const Factors& factors, const QuantiseSettings& settings) {
    return quantise(factors, std::span(&settings, 1));
}

/// The term alone.
Factors one_term(const Factors& factors, size_t term);

/// The s of weights, one more than maps: the proportions of w_0 and of all w_k^f(k) are kept, the product is 1 (Factor 4.3.1).
std::vector<float> prescale_of_weights(const Parametrization& parametrization, const std::vector<float>& weights);

}  // namespace burnish
