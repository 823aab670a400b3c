// Distant light convolved with spherical Gaussians exp((cos - 1) / sigma^2) of every width: one trilinear lookup reads one.
//
// Level 0 is the map as it is. From level 1 on the widths grow by sqrt(2), and from 1.6 degrees on, where levels are small, by its
// root, so that a blend of two is as good as a Gaussian. A texel at a face's centre is no wider than 3/4 sigma, then 1/2
// (sigma on level 1, the first that the map can hold). A level's width is that of its lookups: the texels' own area, the
// kernels and the bilinear tent together, as a mean versine (gaussian_width.h), which a blend of two levels keeps. Levels 1 and
// 2 are sums over texels, the next ones come from one sqrt(2) narrower by a few lookups a texel, and those wider than 1/3 are
// sums over a level of a third of the width: there a Gaussian of a Gaussian is no Gaussian any more.
//
// The fourth channel of the levels bounds how sharply their light bends, see light_curvature.h.
#pragma once

#include <burnish/light/filter/cube_stack.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace burnish {

class GaussianStack {
public:
    GaussianStack() = default;
    /// From six square RGB faces of one size. Throws Error(bad_argument).
    explicit GaussianStack(const std::array<Image, 6>& faces);

    const CubeStack& stack() const { return m_stack; }

    /// The level whose lookups are the light convolved with a Gaussian of `sigma` (radian), clamped to the stack: k + f
    /// between levels k and k + 1, f linear in the mean versine (sigma^2 where it is small).
    float level(float sigma) const;
    /// The same from a table, within 0.01 of a level.
    float quick_level(float sigma) const {
        const float square = std::min(std::max(sigma * sigma, kLeastSquare), kLargestSquare);
        const uint32_t steps = (std::bit_cast<uint32_t>(square) - std::bit_cast<uint32_t>(kLeastSquare)) >> kStepBits;
        const float from = std::bit_cast<float>(std::bit_cast<uint32_t>(kLeastSquare) + (steps << kStepBits));
        const LevelStep& step = m_level_steps[steps];
        return step.level + (square - from) * step.slope;
    }
    /// The inverse, for levels in the stack.
    float sigma(float level) const;

private:
    /// Levels by the square of the width, whose octaves are cut in 32 equal parts.
    struct LevelStep {
        float level, slope;
    };
    static constexpr float kLeastSquare = 0x1p-30f, kLargestSquare = 0x1p6f;
    static constexpr int kStepBits = 18;
    void set_level_steps();

    CubeStack m_stack;
    std::vector<LevelStep> m_level_steps;
    std::vector<float> m_versines;  // of the levels' lookups
};

}  // namespace burnish
