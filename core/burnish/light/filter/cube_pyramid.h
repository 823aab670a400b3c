// A seamless cube map with its MIP pyramid: every filtered lookup of distant light goes through here.
//
// Axes are the light's own: OpenEXR's, right-handed, Y up. Faces +X -X +Y -Y +Z -Z; (right, top) of the faces as seen in
// the image: +X(+Z,+Y) -X(-Z,+Y) +Y(+X,+Z) -Y(+X,-Z) +Z(-X,+Y) -Z(+X,+Y). Texel centres are at +0.5.
#pragma once

#include <burnish/light/filter/cube_stack.h>

namespace burnish {

/// How a level is made from the finer one; all weights include the texels' solid angles, so energy is kept.
enum class PyramidKernel { box2, binomial4, binomial6 };

class CubePyramid {
public:
    CubePyramid() = default;
    /// From six square RGB faces (N x N x 3, N a power of two). Throws Error(bad_argument).
    CubePyramid(const std::array<Image, 6>& faces, PyramidKernel kernel);

    int face_size() const { return level_count() > 0 ? m_stack[0].size() : 0; }
    int level_count() const { return m_stack.level_count(); }

    const CubeStack& stack() const { return m_stack; }
    /// Radiance around unit direction d at a MIP level (0 = finest), see CubeStack::lookup.
    Color3f lookup(const Vec3f& d, float level) const { return m_stack.lookup(d, level); }

    /// The level at which a texel covers `solid_angle` steradian around d (Regular eq. 16):
    /// log4( (N^2 / 4) solid_angle s^3 ), s = |d| / max |d_k|; may be negative.
    float level(const Vec3f& d, float solid_angle) const { return level(solid_angle) + kDistortion * cube_distortion(d); }
    /// The same at a face's centre, s = 1.
    float level(float solid_angle) const { return 0.5f * std::log2(m_texels_per_area * solid_angle); }
    /// Levels per octave of s.
    static constexpr float kDistortion = 1.5f;

    /// RGB of a texel, x and y in [-1, size] (one bordering texel on each side).
    Color3f texel(int level, int face, int x, int y) const;

private:
    CubeStack m_stack;
    float m_texels_per_area = 0.0f;  // N^2 / 4: texels per unit area of the cube [-1, 1]^3
};

}  // namespace burnish
