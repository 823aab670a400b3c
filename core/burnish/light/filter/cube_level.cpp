#include <burnish/light/filter/cube_level.h>

#include <burnish/base/parallel.h>

namespace burnish {
namespace {

void copy_texel(const float* from, float* to) { std::copy_n(from, 4, to); }

}  // namespace

void CubeLevel::fill(const std::array<Image, 6>& faces) {
    for_each_index(6 * m_size, [&](int row) {
        const int face = row / m_size, y = row % m_size;
        for (int x = 0; x < m_size; ++x) {
            float* texel = at(face, x, y);
            std::copy_n(faces[face].at(x, y), 3, texel);
            const float y709 = luminance({texel[0], texel[1], texel[2]});
            texel[3] = y709 * y709;
        }
    });
    fill_borders();
}

void CubeLevel::fill_borders() {
    const auto beyond = [&](int face, int x, int y) -> const float* {
        const CubeTexel t = unfolded_texel(face, x, y, m_size);
        return at(t.face, t.x, t.y);
    };
    const int last = m_size - 1;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < m_size; ++i) {
            for (const int edge : {-1, m_size}) {
                copy_texel(beyond(face, i, edge), at(face, i, edge));
                copy_texel(beyond(face, edge, i), at(face, edge, i));
            }
        }
        for (const int x : {-1, m_size}) {
            for (const int y : {-1, m_size}) {
                const int inner_x = std::clamp(x, 0, last), inner_y = std::clamp(y, 0, last);
                const float *own = at(face, inner_x, inner_y), *across_x = at(face, x, inner_y),
                            *across_y = at(face, inner_x, y);
                for (int k = 0; k < 4; ++k) at(face, x, y)[k] = (own[k] + across_x[k] + across_y[k]) / 3.0f;
            }
        }
    }
}

}  // namespace burnish
