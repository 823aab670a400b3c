// The Gaussian over whole texels: w_i = Omega_i exp(-(1 - cos) / sigma^2), cut off where it is 4e-3 of its peak.
#include <burnish/base/parallel.h>
#include <burnish/light/gaussian_blur.h>

#include <vector>

namespace burnish {
namespace {

constexpr double kCutOff = 5.5;        // in (1 - cos) / sigma^2
constexpr double kSmallCapSine = 0.3;  // up to here a cap's rows are found in closed form

/// Variance of the cut-off Gaussian with this mean versine: (1 - cos) / sigma^2 is distributed as exp(-x), x in [0, kCutOff].
double cut_off_variance(double versine) {
    const double variance = versine / (1.0 - kCutOff / std::expm1(kCutOff));
    if (2.0 / variance > kCutOff) return variance;
    const double sigma = sigma_of_versine(versine);
    return sigma * sigma;
}

/// exp(-x) for x in [0, kCutOff], to 1e-4; a polynomial, because compilers vectorise it.
float exp_minus(float x) {
    const float y = x * (1.0f / 8.0f);
    const float p = 1.0f - y * (1.0f - y * (1.0f / 2.0f) * (1.0f - y * (1.0f / 3.0f) * (1.0f - y * (1.0f / 4.0f))));
    const float p2 = p * p, p4 = p2 * p2;
    return p4 * p4;
}

struct Range {
    int first, last;  // inclusive; empty when last < first
};

/// A cap of directions around d with (1 - cos) <= reach, as a kernel over the texels of faces with `size` texels a side.
class Cap {
public:
    Cap(double versine, int size)
        : m_variance(cut_off_variance(versine)),
          m_reach(std::min(2.0, kCutOff * m_variance)),
          m_sine2(m_reach * (2.0 - m_reach)),
          m_small(m_reach < 1.0 && m_sine2 < kSmallCapSine * kSmallCapSine),
          m_size(size) {}

    /// Rows of a face that hold texel centres in the cap, d = (forward, right, up) unit.
    Range rows(const Vec3f& d) const {
        if (!m_small) return {0, m_size - 1};
        const double sine = std::sqrt(m_sine2);
        if (d.x <= sine) return {0, -1};
        const auto [low, high] = extent(d.x, d.z);
        return texels(-high, -low);
    }

    /// Whether all of it is on the face whose forward axis d.x is along.
    bool on_the_face(const Vec3f& d) const {
        if (!m_small || d.x * d.x <= m_sine2) return false;
        const auto [left, right] = extent(d.x, d.y);
        const auto [bottom, top] = extent(d.x, d.z);
        return left >= -1.0 && right <= 1.0 && bottom >= -1.0 && top <= 1.0;
    }

    /// The texels of a row at height `up` in [-1, 1].
    Range columns(const Vec3f& d, double up) const {
        const double cosine2 = 1.0 - m_sine2, forward = d.x + d.z * up;
        const double a = static_cast<double>(d.y) * d.y - cosine2, b = d.y * forward,
                     c = forward * forward - cosine2 * (1.0 + up * up), square = b * b - a * c;
        if (!m_small || a >= 0.0) return {0, m_size - 1};
        if (square < 0.0) return {0, -1};
        const double root = std::sqrt(square);
        return texels((-b + root) / a, (-b - root) / a);
    }

    /// Weights of the texels of a row: columns [range.first, range.last].
    double weigh(const Vec3f& d, float up, const Range& range, float* weights) const {
        const float step = 2.0f / static_cast<float>(m_size), area = step * step,
                    sharpness = static_cast<float>(1.0 / m_variance), reach = static_cast<float>(m_reach);
        float total = 0;
        for (int i = 0; i <= range.last - range.first; ++i) {
            const float right = (static_cast<float>(range.first + i) + 0.5f) * step - 1.0f;
            const float q = 1.0f / (1.0f + right * right + up * up), s = std::sqrt(q);
            const float x = d.y * up - d.z * right, y = d.z - d.x * up, z = d.x * right - d.y;
            const float cosine = (d.x + d.y * right + d.z * up) * s, sine2 = (x * x + y * y + z * z) * q;
            const float versine = cosine > 0.0f ? sine2 / (1.0f + cosine) : 1.0f - cosine;
            weights[i] = versine <= reach ? area * q * s * exp_minus(versine * sharpness) : 0.0f;
            total += weights[i];
        }
        return total;
    }

private:
    /// tan of the angles between which the cap lies, in the plane of the forward axis and another.
    std::array<double, 2> extent(double forward, double other) const {
        const double mean = forward * other, root = std::sqrt(m_sine2 * (forward * forward + other * other - m_sine2)),
                     scale = 1.0 / (forward * forward - m_sine2);
        return {(mean - root) * scale, (mean + root) * scale};
    }
    Range texels(double low, double high) const {
        const double half = 0.5 * m_size, first = std::ceil(half * (low + 1.0) - 0.5),
                     last = std::floor(half * (high + 1.0) - 0.5);
        return {static_cast<int>(std::clamp(first, 0.0, 1.0 * m_size)), static_cast<int>(std::clamp(last, -1.0, m_size - 1.0))};
    }

    double m_variance, m_reach, m_sine2;
    bool m_small;
    int m_size;
};

/// Texels of one face in runs along its rows, with their weights.
class Footprint {
public:
    void clear() { m_runs.clear(), m_weights.clear(), m_total = 0; }

    /// The part of the cap around d = (forward, right, up) on the face that `offset` is the first texel of.
    void add(const Cap& cap, const Vec3f& d, int size, size_t offset) {
        const Range rows = cap.rows(d);
        for (int y = rows.first; y <= rows.last; ++y) {
            const double up = 1.0 - (2.0 * y + 1.0) / size;
            const Range range = cap.columns(d, up);
            if (range.last < range.first) continue;
            const size_t old = m_weights.size(), count = range.last - range.first + 1;
            m_weights.resize(old + count);
            m_total += cap.weigh(d, static_cast<float>(up), range, &m_weights[old]);
            m_runs.push_back({offset + 4 * (static_cast<size_t>(y) * (size + 2) + range.first), static_cast<int>(count)});
        }
    }

    void sum(const float* texels, float* out) const {
        float total[4] = {0, 0, 0, 0};
        const float* weight = m_weights.data();
        for (const Run& run : m_runs) {
            const float* texel = texels + run.offset;
            for (int i = 0; i < run.count; ++i, ++weight, texel += 4) {
                for (int k = 0; k < 4; ++k) total[k] += *weight * texel[k];
            }
        }
        for (int k = 0; k < 4; ++k) out[k] = total[k] / static_cast<float>(m_total);
    }

private:
    struct Run {
        size_t offset;
        int count;
    };
    std::vector<Run> m_runs;
    std::vector<float> m_weights;
    double m_total = 0;
};

/// The cap's texels on all the faces, offsets from the first texel of the cube.
void add_everywhere(const Cap& cap, const Vec3f& world, const CubeLevel& source, Footprint& footprint) {
    for (int face = 0; face < 6; ++face) {
        const auto offset = static_cast<size_t>(source.at(face, 0, 0) - source.at(0, 0, 0));
        footprint.add(cap, cube_to_face(face, world), source.size(), offset);
    }
}

}  // namespace

void blur_by_sum(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target) {
    const int n = target.size();
    for_each_index(n, [&](int y) {
        Footprint footprint;
        for (int x = 0; x < n; ++x) {
            const Vec3f place = face_place(x, y, n), d = place.normalized();
            const Cap cap(blur.kernel_versine(1.0 / place.length2(), n), source.size());
            footprint.clear();
            const bool shared = cap.on_the_face(d);
            if (shared) footprint.add(cap, d, source.size(), 0);
            for (int face = 0; face < 6; ++face) {
                if (!shared) {
                    footprint.clear();
                    add_everywhere(cap, face_to_cube(face, d), source, footprint);
                }
                footprint.sum(source.at(shared ? face : 0, 0, 0), target.at(face, x, y));
            }
        }
    });
    target.fill_borders();
}

}  // namespace burnish
