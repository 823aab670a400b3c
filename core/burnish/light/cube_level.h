// One level of a cube map, stored so that a bilinear lookup needs no neighbour: each face carries a border of one texel.
#pragma once

#include <burnish/base/image.h>
#include <burnish/light/cube_faces.h>

#include <array>
#include <cstddef>
#include <vector>

namespace burnish {

/// RGBA texels (A unused, for alignment), six faces of (size + 2)^2. A border texel is the neighbouring face's texel beyond
/// the edge; a border corner is the mean of the three texels that meet there, which makes bilinear lookups continuous.
class CubeLevel {
public:
    CubeLevel() = default;
    explicit CubeLevel(int size)
        : m_size(size),
          m_stride(size + 2),
          m_face_texels(static_cast<size_t>(m_stride) * m_stride),
          m_rgba(m_face_texels * 24) {}
    /// From six square images of one size, three or more channels (R, G, B first); borders are filled.
    explicit CubeLevel(const std::array<Image, 6>& faces);

    int size() const { return m_size; }

    /// RGBA of a texel, x and y in [-1, size].
    const float* at(int face, int x, int y) const { return &m_rgba[4 * index(face, x, y)]; }
    float* at(int face, int x, int y) { return &m_rgba[4 * index(face, x, y)]; }

    /// Copies the border texels from the faces' interiors.
    void fill_borders();

    /// Adds `weight` times the bilinear value at `c` to the four floats `sum`.
    void add_bilinear(const CubeCoord& c, float weight, float* sum) const {
        const float px = c.x * static_cast<float>(m_size) + 0.5f, py = c.y * static_cast<float>(m_size) + 0.5f;
        const int ix = static_cast<int>(px), iy = static_cast<int>(py);
        const float fx = px - static_cast<float>(ix), fy = (py - static_cast<float>(iy)) * weight;
        const float* top = &m_rgba[4 * (static_cast<size_t>(c.face) * m_face_texels + static_cast<size_t>(iy) * m_stride + ix)];
        const float* bottom = top + 4 * static_cast<size_t>(m_stride);
        const float w11 = fx * fy, w01 = fy - w11, w10 = fx * weight - w11, w00 = weight - fy - w10;
        for (int k = 0; k < 4; ++k) sum[k] += w00 * top[k] + w10 * top[k + 4] + w01 * bottom[k] + w11 * bottom[k + 4];
    }

private:
    size_t index(int face, int x, int y) const {
        return static_cast<size_t>(face) * m_face_texels + static_cast<size_t>(y + 1) * m_stride + (x + 1);
    }

    int m_size = 0, m_stride = 0;
    size_t m_face_texels = 0;
    std::vector<float> m_rgba;
};

}  // namespace burnish
