// The `reference` estimator: quasi-Monte-Carlo over the unfiltered light until its own error estimate is small enough.
//
// Half of the samples follow the lobe, half the light, combined by the balance heuristic (Veach & Guibas 1995), so that
// neither a sharp lobe nor a small sun is missed. Rounds are independent Owen-scrambled Sobol' sets: their spread
// is an honest standard error.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/estimator.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/shading_point.h>

namespace burnish {

struct ReferenceEstimate {
    Color3f mean{0, 0, 0};
    float standard_error = 0;        // of the luminance of `mean`
    int lookups = 0;
};

inline constexpr int kRoundPairs = 32;       // lobe samples per round, and light samples per round
inline constexpr int kMinRounds = 8;         // before the spread of rounds says anything

/// One round: the mean over kRoundPairs pairs.
template <class LobeType>
Color3f reference_round(const LobeType& lobe, const Environment& light, const ShadingPoint& point, uint32_t seed) {
    Color3f sum(0, 0, 0);
    const auto add = [&](const Vec3f& wi, const Vec3f& d, float pdf_lobe, float pdf_light) {
        const float cos_i = wi.z * lobe.side_sign;
        if (cos_i <= 0 || pdf_lobe + pdf_light <= 0 || !point.sees(wi, lobe.side_sign)) return;
        sum += lobe.eval(point.wo, wi) * light.radiance(d) * (cos_i / (pdf_lobe + pdf_light));
    };
    for (int i = 0; i < kRoundPairs; ++i) {
        const Vec3f wi = lobe.sample(point.wo, owen_sobol(i, seed));
        const Vec3f d = point.frame.to_world(wi);
        add(wi, d, lobe.pdf(point.wo, wi), light.pdf(d));
        float pdf_light = 0;
        const Vec3f to_light = light.sample(owen_sobol(i, seed ^ 0x9e3779b9u), pdf_light);
        const Vec3f local = point.frame.to_local(to_light);
        add(local, to_light, lobe.pdf(point.wo, local), pdf_light);
    }
    return sum / static_cast<float>(kRoundPairs);
}

/// Rounds until the standard error is below `tolerance` of the mean, or until `max_samples` lookups. `seed` from the pixel.
template <class LobeType>
ReferenceEstimate reference_estimate(const LobeType& lobe, const Environment& light, const EstimatorSettings& settings,
                                     const ShadingPoint& point, uint32_t seed) {
    ReferenceEstimate result;
    Color3f sum(0, 0, 0);
    double mean = 0, deviation = 0;      // Welford over the rounds' luminance
    for (int round = 0;; ++round) {
        const Color3f estimate = reference_round(lobe, light, point, hash_bits(seed + round * 0x85ebca6bu));
        sum += estimate;
        const double delta = luminance(estimate) - mean;
        mean += delta / (round + 1);
        deviation += delta * (luminance(estimate) - mean);
        result.lookups += 2 * kRoundPairs;
        const double error = round > 0 ? std::sqrt(deviation / round / (round + 1)) : mean;
        const bool converged = round + 1 >= kMinRounds && error <= settings.tolerance * mean;
        if (!converged && result.lookups + 2 * kRoundPairs <= settings.max_samples) continue;
        result.mean = sum / static_cast<float>(round + 1);
        result.standard_error = static_cast<float>(error);
        return result;
    }
}

}  // namespace burnish
