#include <burnish/frequency/light_bandwidth.h>

#include <burnish/base/parallel.h>
#include <burnish/frequency/light_luminance.h>
#include <burnish/frequency/local_bandwidth.h>
#include <burnish/light/environment.h>

#include <algorithm>
#include <vector>

namespace burnish {
namespace {

/// s^2 at a texel's centre.
float squared_distance(int x, int y, int size) { return face_place(x, y, size).length2(); }

/// Cycles per radian of each texel of a face.
Image face_bandwidth(const CubeLevel& light, int face) {
    const int size = light.size(), bands = band_count(size);
    const Image surrounded = surrounded_face(light, face, surround_width(bands));
    Image nu = surrounded_bandwidth(surrounded, size, size, bands, {});
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) *nu.at(x, y) *= 0.5f * static_cast<float>(size) * squared_distance(x, y, size);
    }
    return nu;
}

/// Maxima of 2 x 2 texels.
Image halved(const Image& fine) {
    Image coarse(fine.width / 2, fine.height / 2, 1);
    for (int y = 0; y < coarse.height; ++y) {
        for (int x = 0; x < coarse.width; ++x) {
            const float *top = fine.at(2 * x, 2 * y), *bottom = fine.at(2 * x, 2 * y + 1);
            *coarse.at(x, y) = std::max({top[0], top[1], bottom[0], bottom[1]});
        }
    }
    return coarse;
}

CubeLevel level_of(const std::array<Image, 6>& faces) {
    const int size = faces[0].width;
    CubeLevel level(size);
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) *level.at(face, x, y) = *faces[face].at(x, y);
        }
    }
    level.fill_borders();
    return level;
}

/// Maxima of 3 x 3 texels, across the faces' edges. At a corner three faces meet: the border's mean of them is no new maximum.
void widen(const CubeLevel& in, CubeLevel& out) {
    const int size = in.size();
    for_each_index(6 * size, [&](int row) {
        const int face = row / size, y = row % size;
        for (int x = 0; x < size; ++x) {
            float largest = 0.0f;
            for (int k = 0; k < 9; ++k) largest = std::max(largest, *in.at(face, x + k % 3 - 1, y + k / 3 - 1));
            std::fill_n(out.at(face, x, y), 4, 0.0f);
            *out.at(face, x, y) = largest;
        }
    });
    out.fill_borders();
}

}  // namespace

LightBandwidth::LightBandwidth(const Environment& light) : LightBandwidth(light.faces(), light.discs()) {}

LightBandwidth::LightBandwidth(const std::array<Image, 6>& faces, std::span<const BrightDisc> discs) {
    const CubeLevel light = light_luminance(faces, discs, kLargestFace);
    std::array<Image, 6> nu;
    for_each_index(6, [&](int face) { nu[face] = face_bandwidth(light, face); });
    std::vector<int> sizes = {light.size()};
    for (int size = light.size(); size > 0; size /= 2) sizes.push_back(size);
    m_maxima = CubeStack(sizes);
    widen(level_of(nu), m_maxima[0]);
    widen(m_maxima[0], m_maxima[1]);
    for (int level = 2; level < m_maxima.level_count(); ++level) {
        for_each_index(6, [&](int face) { nu[face] = halved(nu[face]); });
        CubeLevel once(sizes[level]);
        widen(level_of(nu), once);
        widen(once, m_maxima[level]);
    }
}

// Four texels are read, whose centres are up to a texel away: the first level's reach half a texel beyond that, the others' one
// and a half.
float LightBandwidth::level(const Vec3f& d, float radius) const {
    const float texels = radius * 0.5f * static_cast<float>(m_maxima[0].size()) * std::exp2(2.0f * cube_distortion(d));
    if (texels <= 0.5f) return 0.0f;
    const float wanted = 1.0f + std::ceil(std::log2(std::max(1.0f, texels / 1.5f)));
    return std::min(wanted, static_cast<float>(m_maxima.level_count() - 1));
}

}  // namespace burnish
