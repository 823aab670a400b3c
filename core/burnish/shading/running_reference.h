// The `reference` estimator stopped and taken up again: what its sequences have summed up at one pixel, all lobes together.
//
// A pass adds the next points of every sequence, so any number of passes, made at any time, give what one run of as many does; and
// because replicates are kept apart, the standard error shrinks at the quasi-Monte-Carlo rate, too.
#pragma once

#include <burnish/shading/reference.h>

namespace burnish {

struct RunningReference {
    Color3f sum{0, 0, 0};                         // of all points
    std::array<float, kReplicates> luminances{};  // of each replicate's sum
    int points = 0;                               // of each replicate, so far

    int lookups_per_lobe() const { return points * kReplicates * 2; }
    Color3f mean() const { return sum / static_cast<float>(std::max(points, 1) * kReplicates); }

    /// Of the luminance of `mean`.
    float standard_error() const {
        const float middle = luminance(mean()), scale = 1 / static_cast<float>(std::max(points, 1));
        float square = 0;
        for (const float replicate : luminances) square += std::pow(replicate * scale - middle, 2.0f);
        return std::sqrt(square / (kReplicates * (kReplicates - 1)));
    }

    /// Whether the standard error is below `tolerance` of the mean and there are enough points to believe it.
    bool is_within(float tolerance) const {
        return points >= kMinPasses * kPassPoints && standard_error() <= tolerance * luminance(mean());
    }
};

/// One lobe's part of the next pass, times `scale`; `points` is left to the caller. `seed` from pixel and lobe.
template <class LobeType, class Arrival>
void add_reference_pass(const LobeType& lobe, const Arrival& light, const ShadingPoint& point, uint32_t seed,
                        const Color3f& scale, RunningReference& running) {
    for (int r = 0; r < kReplicates; ++r) {
        Color3f sum(0, 0, 0);
        for (int i = running.points; i < running.points + kPassPoints; ++i)
            sum += reference_pair(lobe, light, point, i, hash_bits(seed, 2 + r));
        sum *= scale;
        running.sum += sum, running.luminances[r] += luminance(sum);
    }
}

}  // namespace burnish
