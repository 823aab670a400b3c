// A seamless cube map with its MIP pyramid: every filtered lookup of distant light goes through here.
//
// Axes are the light's own: OpenEXR's, right-handed, Y up. Faces +X -X +Y -Y +Z -Z; (right, top) of the faces as seen in
// the image: +X(+Z,+Y) -X(-Z,+Y) +Y(+X,+Z) -Y(+X,-Z) +Z(-X,+Y) -Z(+X,+Y).
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <array>
#include <vector>

namespace burnish {

/// How a level is made from the finer one; all weights include the texels' solid angles, so energy is kept.
enum class PyramidKernel { box2, binomial4, binomial6 };

class CubePyramid {
public:
    CubePyramid() = default;
    /// From six square RGB faces (N x N x 3, N a power of two).
    CubePyramid(const std::array<Image, 6>& faces, PyramidKernel kernel);

    int face_size() const { return m_levels.empty() ? 0 : m_levels[0].size; }
    int level_count() const { return static_cast<int>(m_levels.size()); }

    /// Radiance around unit direction d at a MIP level (0 = finest; clamped to the pyramid), trilinear, across faces
    /// without a seam.
    Color3f lookup(const Vec3f& d, float level) const;

    /// The level at which a texel covers `solid_angle` steradian around d (Regular eq. 16):
    /// log4( (N^2 / 4) solid_angle s^3 ), s = |d| / max |d_k|; may be negative.
    float level(const Vec3f& d, float solid_angle) const;

    /// RGB of a texel, x and y in [-1, size] (one bordering texel on each side).
    Color3f texel(int level, int face, int x, int y) const;

private:
    /// One level: RGBA texels, six faces of (size + 2)^2, the border copied from the neighbouring faces.
    struct Level {
        int size = 0;
        std::vector<float> rgba;
    };
    std::vector<Level> m_levels;
};

/// Face index and position in the face, x right and y down in [0, 1]^2, of a direction; and back (unit length).
struct CubeCoord {
    int face;
    float x, y;
};
CubeCoord cube_coord(const Vec3f& d);
Vec3f cube_direction(int face, float x, float y);

}  // namespace burnish
