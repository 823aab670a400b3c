// Sums over all texels of a cube under a wide Gaussian. The weights around one place are those around its mirror images on all six
// faces, with the texels turned along: they are made once for 24 places.
#pragma once

#include <burnish/light/filter/cube_level.h>
#include <burnish/light/filter/gaussian_cap.h>

#include <span>
#include <vector>

namespace burnish {

/// Which texels of a cube take the place of its own when it is turned or mirrored so that a place on face 0 comes to lie on `face`,
/// mirrored there.
class CubeImage {
public:
    CubeImage(const CubeLevel& cube, int face, bool mirror_x, bool mirror_y);

    /// In floats from the first texel of the cube: where texel (0, 0) of a face went, and the steps along its rows and columns.
    struct Grid {
        std::ptrdiff_t origin, x, y;
    };
    const Grid& grid(int face) const { return m_grids[face]; }

private:
    std::array<Grid, 6> m_grids;
};

class SphereSum {
public:
    /// `cosines`: texel_cosines of the source. All outlive this.
    SphereSum(const CubeLevel& source, std::span<const float> cosines) : m_source(source), m_cosines(cosines) {}

    /// Takes the weights around unit direction d, along (forward, right, up) of face 0.
    void fill(const GaussianCap& cap, const Vec3f& d);
    /// Their mean at the image of that place.
    void mean(const CubeImage& image, float* rgba) const;

private:
    const CubeLevel& m_source;
    std::span<const float> m_cosines;
    std::vector<float> m_weights;  // of the six faces' texels
    std::vector<bool> m_is_empty;  // rows of these
};

}  // namespace burnish
