// Distant light convolved with spherical Gaussians exp((cos - 1) / sigma^2) of every width: one trilinear lookup reads one.
//
// gaussian_levels.h says which widths its levels have. They are filtered when somebody asks for them, so a rough material never
// pays for fine levels; a level's texels are the same bits whatever was asked for before. The fourth channel of the levels bounds
// how sharply their light bends, see light_curvature.h.
#pragma once

#include <burnish/light/filter/cube_stack.h>
#include <burnish/light/filter/gaussian_levels.h>
#include <burnish/light/filter/level_range.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace burnish {

class GaussianStack {
public:
    GaussianStack() = default;
    /// From six square RGB faces of one size. Throws Error(bad_argument).
    explicit GaussianStack(std::shared_ptr<const std::array<Image, 6>> faces);
    explicit GaussianStack(std::array<Image, 6> faces);

    /// All levels, filtered. Any thread may call this and the next.
    const CubeStack& stack() const;
    /// What lookups in these ranges read, kernels' neighbouring levels included; levels that nobody has asked for are not set.
    const CubeStack& stack(std::span<const LevelRange> ranges) const;
    const CubeStack& widest() const { return stack(std::array{LevelRange{last_level(), last_level()}}); }

    int level_count() const { return static_cast<int>(m_levels.size()); }
    float last_level() const { return static_cast<float>(level_count() - 1); }
    /// Texels a side of a level's faces.
    int size(int level) const { return m_levels[level].size; }
    /// Whether somebody needed the level so far.
    bool is_filtered(int level) const;
    bool is_whole() const;

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
    class Maker;  // the levels' texels
    /// Levels by the square of the width, whose octaves are cut in 32 equal parts.
    struct LevelStep {
        float level, slope;
    };
    static constexpr float kLeastSquare = 0x1p-30f, kLargestSquare = 0x1p6f;
    static constexpr int kStepBits = 18;
    void set_level_steps();

    std::vector<GaussianLevel> m_levels;
    std::vector<LevelStep> m_level_steps;
    std::vector<float> m_versines;  // of the levels' lookups
    std::shared_ptr<Maker> m_maker;
};

}  // namespace burnish
