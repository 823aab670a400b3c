#include <burnish/light/filter/sphere_sum.h>

#include <numeric>

namespace burnish {

CubeImage::CubeImage(const CubeLevel& cube, int face, bool mirror_x, bool mirror_y) {
    const int n = cube.size();
    const auto offset = [&](int own, int x, int y) {
        const Vec3f v = cube_to_face(0, face_to_cube(own, face_place(x, y, n)));
        const Vec3f turned = face_to_cube(face, {v.x, mirror_x ? -v.y : v.y, mirror_y ? -v.z : v.z});
        const CubeCoord c = cube_coord(turned);
        const auto texel = [&](float place) { return static_cast<int>(place * static_cast<float>(n)); };
        return cube.at(c.face, texel(c.x), texel(c.y)) - cube.at(0, 0, 0);
    };
    for (int own = 0; own < 6; ++own) {
        const std::ptrdiff_t origin = offset(own, 0, 0);
        m_grids[own] = {origin, n > 1 ? offset(own, 1, 0) - origin : 0, n > 1 ? offset(own, 0, 1) - origin : 0};
    }
}

void SphereSum::fill(const GaussianCap& cap, const Vec3f& d) {
    const int n = m_source.size();
    m_is_empty.resize(6 * static_cast<size_t>(n)), m_weights.resize(m_is_empty.size() * n);
    float total = 0;
    for (int row = 0; row < 6 * n; ++row) {
        float* weights = &m_weights[static_cast<size_t>(row) * n];
        cap.weigh(cube_to_face(row / n, face_to_cube(0, d)), row % n, {0, n - 1}, m_cosines, weights);
        const float sum = std::accumulate(weights, weights + n, 0.0f);
        m_is_empty[row] = sum == 0, total += sum;
    }
    for (float& weight : m_weights) weight /= total;
}

void SphereSum::mean(const CubeImage& image, float* rgba) const {
    const int n = m_source.size();
    const float* cube = m_source.at(0, 0, 0);
    float sum[4] = {0, 0, 0, 0};
    for (int row = 0; row < 6 * n; ++row) {
        if (m_is_empty[row]) continue;
        const CubeImage::Grid& grid = image.grid(row / n);
        const float *weights = &m_weights[static_cast<size_t>(row) * n], *texel = cube + grid.origin + row % n * grid.y;
        for (int x = 0; x < n; ++x, texel += grid.x)
            for (int k = 0; k < 4; ++k) sum[k] += weights[x] * texel[k];
    }
    std::copy_n(sum, 4, rgba);
}

}  // namespace burnish
