// Importance sampling of the picture as given: a cell with probability ~ its power, then a place in it uniform in solid
// angle (lat-long) or on the face (cube).
#include <burnish/base/parallel.h>
#include <burnish/light/environment_source.h>
#include <burnish/light/latlong.h>

namespace burnish {
namespace {

/// Mean of the bilinear interpolant over one texel, per axis from its neighbour, itself and its neighbour.
constexpr double kTexelMean[3] = {1 / 8.0, 6 / 8.0, 1 / 8.0};

/// Mean luminance of the bilinear picture over a texel; texel(dx, dy) gives RGB of the neighbours.
template <class Texel>
double texel_mean(Texel&& texel) {
    double sum = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const float* rgb = texel(dx, dy);
            sum += kTexelMean[dx + 1] * kTexelMean[dy + 1] * luminance({rgb[0], rgb[1], rgb[2]});
        }
    }
    return sum;
}

/// Solid angle of one texel in a row of a lat-long.
double row_solid_angle(int row, int width, int height) {
    const double step = std::numbers::pi / height;
    return 2.0 * std::numbers::pi / width * (std::cos(step * row) - std::cos(step * (row + 1)));
}

std::vector<double> latlong_weights(const Image& picture) {
    const int width = picture.width, height = picture.height;
    std::vector<double> weights(picture.pixel_count());
    for_each_index(height, [&](int y) {
        const double omega = row_solid_angle(y, width, height);
        for (int x = 0; x < width; ++x) {
            weights[static_cast<size_t>(y) * width + x] =
                omega * texel_mean([&](int dx, int dy) {
                    return picture.at((x + dx + width) % width, std::clamp(y + dy, 0, height - 1));
                });
        }
    });
    return weights;
}

std::vector<double> cube_weights(const CubeLevel& cube) {
    const int n = cube.size();
    const auto edge = [&](int i) { return 2.0 * i / n - 1.0; };
    std::vector<double> weights(static_cast<size_t>(6 * n) * n);
    for_each_index(6 * n, [&](int row) {
        const int face = row / n, y = row % n;
        for (int x = 0; x < n; ++x) {
            const double omega = cube_solid_angle(edge(x), edge(x + 1), edge(y), edge(y + 1));
            weights[static_cast<size_t>(row) * n + x] =
                omega * texel_mean([&](int dx, int dy) { return cube.at(face, x + dx, y + dy); });
        }
    });
    return weights;
}

/// Steradian per unit area of a face's [0, 1]^2, at d: 4 s^-3, s the length of d where it meets the cube [-1, 1]^3.
float steradian_per_face(const Vec3f& d) {
    const float s = std::sqrt(d.length2()) / std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    return 4.0f / (s * s * s);
}

}  // namespace

const SampleTable& Environment::Source::table() const {
    std::call_once(m_table_made, [this] {
        m_table = is_cube() ? SampleTable(cube().size(), 6 * cube().size(), cube_weights(cube()))
                            : SampleTable(m_latlong.width, m_latlong.height, latlong_weights(m_latlong));
    });
    return m_table;
}

Vec3f Environment::Source::sample(const Vec2f& u, float& density) const {
    const SampleTable::Place place = table().sample(u);
    Vec3f d;
    if (is_cube()) {
        const int n = cube().size();
        d = cube_direction(place.row / n, (static_cast<float>(place.column) + place.x) / static_cast<float>(n),
                           (static_cast<float>(place.row % n) + place.y) / static_cast<float>(n));
    } else {
        const double step = std::numbers::pi / m_latlong.height, top = std::cos(step * place.row),
                     bottom = std::cos(step * (place.row + 1));
        const double v = std::acos(top + (bottom - top) * static_cast<double>(place.y)) / std::numbers::pi;
        d = latlong_direction(
            {(static_cast<float>(place.column) + place.x) / static_cast<float>(m_latlong.width), static_cast<float>(v)});
    }
    density = pdf(d);
    return d;
}

float Environment::Source::pdf(const Vec3f& d) const {
    if (is_cube()) {
        const int n = cube().size();
        const CubeCoord c = cube_coord(d);
        const auto cell = [&](float x) { return std::min(static_cast<int>(x * static_cast<float>(n)), n - 1); };
        const double per_face = table().probability(cell(c.x), c.face * n + cell(c.y)) * n * n;
        return static_cast<float>(per_face / steradian_per_face(d));
    }
    const Vec2f uv = latlong_coord(d);
    const auto cell = [](float x, int count) {
        return std::clamp(static_cast<int>(x * static_cast<float>(count)), 0, count - 1);
    };
    const int column = cell(uv.x, m_latlong.width), row = cell(uv.y, m_latlong.height);
    return static_cast<float>(table().probability(column, row) / row_solid_angle(row, m_latlong.width, m_latlong.height));
}

Vec3f Environment::sample(const Vec2f& u, float& pdf) const { return m_source->sample(u, pdf); }

float Environment::pdf(const Vec3f& d) const { return m_source->pdf(d); }

}  // namespace burnish
