// One level of a cube map, stored so that a bilinear lookup needs no neighbour: each face carries a border of one texel.
#pragma once

#include <burnish/base/image.h>
#include <burnish/light/filter/cube_faces.h>

#include <array>
#include <cstddef>
#include <memory>

namespace burnish {

/// RGBA texels, six faces of (size + 2)^2. A border texel is the neighbouring face's texel beyond
/// the edge; a border corner is the mean of the three texels that meet there, which makes bilinear lookups continuous.
/// Copies share their texels. A is what `fill` makes of a map: its luminance squared, of which filtered levels hold the mean, so
/// that lookups know how much the light varies within their filter (variance = A - luminance^2).
class CubeLevel {
public:
    CubeLevel() = default;
    explicit CubeLevel(int size) : CubeLevel(size, std::make_shared<float[]>(float_count(size))) {}
    /// Over float_count(size) floats that someone else allocated.
    CubeLevel(int size, std::shared_ptr<float[]> rgba)
        : m_size(size), m_stride(size + 2), m_face_texels(static_cast<size_t>(m_stride) * m_stride), m_rgba(std::move(rgba)) {}
    /// From six square images of one size, see `fill`.
    explicit CubeLevel(const std::array<Image, 6>& faces) : CubeLevel(faces[0].width) { fill(faces); }

    /// Takes the texels from six images of this level's size, three or more channels (R, G, B first); fills the borders.
    void fill(const std::array<Image, 6>& faces);

    static size_t float_count(int size) { return static_cast<size_t>(size + 2) * (size + 2) * 24; }

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
    std::shared_ptr<float[]> m_rgba;
};

}  // namespace burnish
