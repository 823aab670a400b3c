// Angular bandwidth of distant light, and the largest one in any lobe of directions by one lookup.
//
// Each cube face is analysed by wavelets on its own plane, continued a quarter of its width beyond its edges by what the
// neighbours see there, so that nothing shows at a seam or at a corner. A frequency in texels becomes one in radians by the
// largest stretch of the mapping, s^2 n / 2 texels a radian, s = |d| / max |d_k|. Discs that were taken out of the picture are
// painted back first: they are as sharp as they are small.
//
// What is kept is a pyramid of maxima. A texel of a level holds the largest bandwidth in it and in two rings of texels around it
// (one on level 0, which has the size of level 1), so that a bilinear read is never below the maximum within one and a half
// texels (half a texel) of where it is made.
#pragma once

#include <burnish/light/bright_discs.h>
#include <burnish/light/filter/cube_stack.h>

#include <array>
#include <span>

namespace burnish {

class Environment;

class LightBandwidth {
public:
    /// Texels per face edge that are analysed at most. Their highest frequency is 64 to 192 cycles a radian, 20 is all that a
    /// lobe of m = 0.01 lets through: finer texels would matter to mirrors of m < 0.003 only.
    static constexpr int kLargestFace = 256;

    LightBandwidth() = default;
    explicit LightBandwidth(const Environment& light);
    /// From six square RGB faces of one size, a power of two, and the discs to add. Throws Error(bad_argument).
    LightBandwidth(const std::array<Image, 6>& faces, std::span<const BrightDisc> discs);

    /// nu_a, cycles per radian: not below the largest local bandwidth within `radius` (radian, up to pi / 4) of direction d (any
    /// length, light axes). Thread-safe.
    float at(const Vec3f& d, float radius) const { return m_maxima.lookup(d, level(d, radius)).x; }

    /// The coarsest level it takes for a cap of `radius` around d; whole, clamped to the stack.
    float level(const Vec3f& d, float radius) const;
    /// Red holds nu_a.
    const CubeStack& maxima() const { return m_maxima; }

private:
    CubeStack m_maxima;
};

}  // namespace burnish
