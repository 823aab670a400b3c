// The levels of a filtered cube map in one block of memory: what every filtered lookup reads, scalar or SIMD.
//
// A stack knows nothing of how its levels were filtered. What a level number means is said by who fills it: CubePyramid
// (MIP levels, by solid angle) or GaussianStack (by the width of a spherical Gaussian).
#pragma once

#include <burnish/light/filter/cube_level.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

class CubeStack {
public:
    CubeStack() = default;
    /// Levels of these face sizes, finest first; their texels are yet to be set (memory is not touched before).
    /// Throws Error(bad_argument) beyond 2^31 texels.
    explicit CubeStack(std::span<const int> sizes);

    int level_count() const { return static_cast<int>(m_levels.size()); }
    CubeLevel& operator[](int level) { return m_levels[level]; }
    const CubeLevel& operator[](int level) const { return m_levels[level]; }

    /// Radiance around direction d (any length) at a fractional level, clamped to the stack; bilinear in the faces, linear
    /// between levels, without a seam. The stack must not be empty.
    Color3f lookup(const Vec3f& d, float level) const {
        const std::array<float, 4> rgba = lookup_rgba(d, level);
        return {rgba[0], rgba[1], rgba[2]};
    }
    /// The same with the levels' fourth channel.
    std::array<float, 4> lookup_rgba(const Vec3f& d, float level) const {
        const CubeCoord c = cube_coord(d);
        const float clamped = std::min(std::max(0.0f, level), static_cast<float>(level_count() - 1));
        const int fine = static_cast<int>(clamped);
        const float blend = clamped - static_cast<float>(fine);
        std::array<float, 4> sum{};
        m_levels[fine].add_bilinear(c, 1.0f - blend, sum.data());
        if (blend > 0.0f) m_levels[fine + 1].add_bilinear(c, blend, sum.data());
        return sum;
    }

    /// Where texels are, for kernels: level k has sizes[k] texels a side and starts at texel begins[k] of `rgba`. The last
    /// level stands there again, at least once, up to kShortTable entries or more.
    struct Layout {
        const float* rgba = nullptr;
        float last_level = 0;
        std::vector<float> sizes;
        std::vector<int32_t> begins;
    };
    static constexpr int kShortTable = 16;
    const Layout& layout() const { return m_layout; }

private:
    std::vector<CubeLevel> m_levels;
    Layout m_layout;
};

}  // namespace burnish
