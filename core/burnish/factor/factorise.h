// Homomorphic factorisation: a product of maps for any samples of a function. The logarithm of a product is a sum, which is linear in
// the logarithms of texels (Factor 3.1.2); `polish` then fits the product itself, as it is looked up, by the error that counts.
// Source: McCool, Ang & Ahmad 2001, "Homomorphic factorization of BRDFs for high-performance rendering".
#pragma once

#include <burnish/base/progress.h>
#include <burnish/factor/factors.h>

#include <span>

namespace burnish {

/// Which error is made least, on average over samples and channels.
enum class FactorMeasure {
    relative,  // |error| / (value + bias)
    display,   // the square of the error as shown with the mean at middle grey (display.h)
    absolute,  // the square of the error
};

struct FactoriseSettings {
    int size = 64;                               // texels a side of a disc or face
    Mapping sphere = Mapping::double_parabolic;  // of directions all around
    FactorMeasure measure = FactorMeasure::relative;
    float smoothness = 0.02f;  // lambda: what a texel's Laplacian counts against the samples that read it
    float bias = 1e-5f;        // epsilon: of the mean, added before logarithms are taken
    int iterations = 200;      // of conjugate gradients, at most
    float tolerance = 1e-4f;   // of the gradient
    int terms = 0;             // products that are summed, 0 = as many as the parametrisation says; they have signs if several
    bool polish = true;        // else the error of logarithms is made least, by one term
};

/// Throws Error(bad_argument) for no samples, for directions, values or weights
/// that are not finite or are below zero, and for sizes out of range.
Factors factorise(const Parametrization& parametrization, std::span<const FactorSample> samples, const FactorGuide& guide,
                  const FactoriseSettings& settings = {}, const Progress& progress = {});

}  // namespace burnish
