// The `reference` estimator: quasi-Monte-Carlo over the unfiltered light until its own error estimate is small enough.
//
// Half of the samples follow the lobe, half the light, combined by the balance heuristic (Veach & Guibas 1995), so that
// neither a sharp lobe nor a small sun is missed. Several independently Owen-scrambled Sobol' sequences run side by side: each
// converges at the quasi-Monte-Carlo rate, and the spread of their means is an honest standard error.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/light/light_ray.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/estimator.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/shading_point.h>

#include <algorithm>
#include <array>

namespace burnish {

struct ReferenceEstimate {
    Color3f mean{0, 0, 0};
    float standard_error = 0;  // of the luminance of `mean`
    int lookups = 0;
};

inline constexpr int kReplicates = 16;  // independent sequences
inline constexpr int kPassPoints = 4;   // points each sequence adds per pass
inline constexpr int kMinPasses =
    16;  // 2048 lookups: fewer may miss a small lamp altogether, and then the spread knows nothing of it
inline constexpr int kPassLookups = 2 * kReplicates * kPassPoints;

/// Passes after which a first look at the error pays, for light of this relative standard deviation under the lobe: about half of
/// what pixels like it need in the end (docs/measured.md); lookups go like tolerance^(-4/3).
inline int predicted_passes(float deviation, float tolerance) {
    constexpr float kTypicalDeviation = 0.4f, kTypicalTolerance = 0.005f, kFewest = 4, kMost = 64;
    const float passes = kMinPasses * (deviation / kTypicalDeviation) * std::pow(kTypicalTolerance / tolerance, 4.0f / 3);
    return static_cast<int>(std::clamp(passes, kFewest, kMost));
}

/// The whole sphere's light at one point, in the axes of the point's frame: radiance and density along a direction, and a draw.
struct DistantArrival {
    const Environment& light;

    ExactLight exact(const Vec3f& d) const { return {light.radiance(d), 1.0f, light.pdf(d)}; }
    LightDraw sample(const Vec2f& u) const {
        LightDraw draw;
        draw.d = light.sample(u, draw.pdf);
        return draw;
    }
};

/// Point `index` of one sequence: a lobe sample and a light sample. `light`: as DistantArrival.
template <class LobeType, class Arrival>
Color3f reference_pair(const LobeType& lobe, const Arrival& light, const ShadingPoint& point, uint32_t index, uint32_t seed) {
    const auto contribution = [&](const Vec3f& wi, const Vec3f& d) {
        const float cos_i = wi.z * lobe.side_sign;
        if (cos_i <= 0 || !point.sees(wi, lobe.side_sign)) return Color3f(0, 0, 0);
        const ExactLight arriving = light.exact(d);
        const float pdf = lobe.pdf(point.wo, wi) + arriving.pdf;
        return pdf > 0 ? Color3f(lobe.eval(point.wo, wi) * arriving.radiance * (cos_i / pdf)) : Color3f(0, 0, 0);
    };
    const Vec3f wi = lobe.sample(point.wo, owen_sobol(index, seed));
    const LightDraw draw = light.sample(owen_sobol(index, hash_bits(seed, 1)));
    const Color3f by_lobe = contribution(wi, point.frame.to_world(wi));
    return draw.pdf > 0 ? by_lobe + contribution(point.frame.to_local(draw.d), draw.d) : by_lobe;
}

/// Mean of the replicates' sums over `points` points each, and the standard error of its luminance.
inline ReferenceEstimate summary(const std::array<Color3f, kReplicates>& sums, int points) {
    ReferenceEstimate result;
    for (const Color3f& sum : sums) result.mean += sum / static_cast<float>(points * kReplicates);
    float square = 0;
    for (const Color3f& sum : sums) square += std::pow(luminance(sum) / points - luminance(result.mean), 2.0f);
    result.standard_error = std::sqrt(square / (kReplicates * (kReplicates - 1)));
    result.lookups = points * kReplicates * 2;
    return result;
}

/// Of a pixel's lobe: the same in whatever batch or band the pixel comes.
inline uint32_t reference_seed(const SurfaceBatch& batch, size_t i, uint32_t lobe_index) {
    return hash_bits((batch.pixel[i] + batch.band_start) ^ lobe_index * 0xc2b2ae35u);
}

/// Passes until the standard error is below `tolerance` of the mean, looked at from `first_passes` on, or until `max_samples`
/// lookups. `seed` from the pixel.
template <class LobeType, class Arrival>
ReferenceEstimate reference_estimate(const LobeType& lobe, const Arrival& light, const EstimatorSettings& settings,
                                     const ShadingPoint& point, uint32_t seed, int first_passes = kMinPasses) {
    std::array<Color3f, kReplicates> sums;
    sums.fill(Color3f(0, 0, 0));
    for (int points = kPassPoints;; points += kPassPoints) {
        for (int r = 0; r < kReplicates; ++r)
            for (int i = points - kPassPoints; i < points; ++i)
                sums[r] += reference_pair(lobe, light, point, i, hash_bits(seed, 2 + r));
        const ReferenceEstimate result = summary(sums, points);
        const bool converged =
            points >= first_passes * kPassPoints && result.standard_error <= settings.tolerance * luminance(result.mean);
        if (converged || result.lookups + kPassLookups > settings.max_samples) return result;
    }
}

}  // namespace burnish
