#include <burnish/light/filter/gaussian_cap.h>

#include <burnish/base/parallel.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace burnish {
namespace {

constexpr double kCutOff = 5.5;  // in (1 - cos) / s^2
constexpr double kSmallCapSine = 0.3;

/// s^2 of the cut-off Gaussian with this mean versine: (1 - cos) / s^2 is distributed as exp(-x), x in [0, kCutOff].
double cut_off_variance(double versine) {
    static const double kept = 1.0 - kCutOff / std::expm1(kCutOff);
    const double variance = versine / kept;
    if (2.0 / variance > kCutOff) return variance;
    const double sigma = sigma_of_versine(versine);
    return sigma * sigma;
}

/// exp(-x) for x in [0, kCutOff], to 1e-4 of its value; a polynomial, because compilers vectorise it.
float exp_minus(float x) {
    const float y = x * (1.0f / 8.0f);
    const float p = 1.0f - y * (1.0f - y * (1.0f / 2.0f) * (1.0f - y * (1.0f / 3.0f) * (1.0f - y * (1.0f / 4.0f))));
    const float p2 = p * p, p4 = p2 * p2;
    return p4 * p4;
}

}  // namespace

std::vector<float> texel_cosines(int size) {
    std::vector<float> cosines(static_cast<size_t>(size) * size);
    const auto along = [&](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; };
    for_each_index(size, [&](int y) {
        const float up2 = 1.0f + along(y) * along(y);
        for (int x = 0; x < size; ++x) cosines[static_cast<size_t>(y) * size + x] = 1.0f / std::sqrt(up2 + along(x) * along(x));
    });
    return cosines;
}

GaussianCap::GaussianCap(double versine, int size)
    : m_variance(cut_off_variance(versine)),
      m_reach(std::min(2.0, kCutOff * m_variance)),
      m_sine2(m_reach * (2.0 - m_reach)),
      m_small(m_reach < 1.0 && m_sine2 < kSmallCapSine * kSmallCapSine),
      m_size(size) {}

bool GaussianCap::on_the_face(const Vec3f& d) const {
    if (!m_small || d.x * d.x <= m_sine2) return false;
    const auto [left, right] = extent(d.x, d.y);
    const auto [bottom, top] = extent(d.x, d.z);
    return left >= -1.0 && right <= 1.0 && bottom >= -1.0 && top <= 1.0;
}

TexelRange GaussianCap::rows(const Vec3f& d) const {
    if (!m_small) return {0, m_size - 1};
    if (d.x <= 0.0f || d.x * d.x <= m_sine2) return {0, -1};
    const auto [low, high] = extent(d.x, d.z);
    return texels(-high, -low);
}

// The cone (d . D)^2 = cos^2 |D|^2 on the line D = (1, right, up).
TexelRange GaussianCap::columns(const Vec3f& d, int row) const {
    const double up = -along(row), cosine2 = 1.0 - m_sine2, forward = d.x + d.z * up;
    const double a = static_cast<double>(d.y) * d.y - cosine2, b = d.y * forward,
                 c = forward * forward - cosine2 * (1.0 + up * up), square = b * b - a * c;
    if (!m_small || a >= 0.0) return {0, m_size - 1};
    if (square < 0.0) return {0, -1};
    const double root = std::sqrt(square);
    return texels((-b + root) / a, (-b - root) / a);
}

// Without branches, so that compilers vectorise it. 1 - cos comes from the cross product where the cap is small, since cos itself would be 1 in single precision.
void GaussianCap::weigh(const Vec3f& d, int row, const TexelRange& range, std::span<const float> cosines,
                        float* weights) const {
    const auto sharpness = static_cast<float>(1.0 / m_variance), reach = static_cast<float>(m_reach),
               step = 2.0f / static_cast<float>(m_size), first = static_cast<float>(along(range.first)),
               up = static_cast<float>(-along(row)), x = d.y * up, y = d.z - d.x * up, forward = d.x + d.z * up;
    const float dx = d.x, dy = d.y, dz = d.z, *s = &cosines[static_cast<size_t>(row) * m_size + range.first];
    const int count = range.last - range.first + 1, small_count = m_small ? count : 0, wide_count = count - small_count;
    for (int i = 0; i < small_count; ++i) {
        const float right = first + static_cast<float>(i) * step, x2 = x - dz * right, z = dx * right - dy;
        const float sine2 = (x2 * x2 + y * y + z * z) * s[i] * s[i], versine = sine2 * (0.5f + 0.125f * sine2);
        weights[i] = s[i] * s[i] * s[i] * exp_minus(versine * sharpness);
    }
    for (int i = 0; i < wide_count; ++i) {
        const float right = first + static_cast<float>(i) * step, margin = reach - 1.0f + (forward + dy * right) * s[i];
        const float inside = 0.5f * (margin + std::fabs(margin));
        const int outside = std::bit_cast<int>(margin) >> 31;  // -1 or 0
        weights[i] = static_cast<float>(1 + outside) * s[i] * s[i] * s[i] * exp_minus((reach - inside) * sharpness);
    }
}

/// tan of the angles between which the cap lies, in the plane of the forward axis and another.
std::array<double, 2> GaussianCap::extent(double forward, double other) const {
    const double mean = forward * other, root = std::sqrt(m_sine2 * (forward * forward + other * other - m_sine2)),
                 scale = 1.0 / (forward * forward - m_sine2);
    return {(mean - root) * scale, (mean + root) * scale};
}

TexelRange GaussianCap::texels(double low, double high) const {
    const auto edge = [&](double place) {
        return static_cast<int>(std::clamp(0.5 * m_size * (place + 1.0) + 0.5, 0.0, 1.0 * m_size));
    };
    return {edge(low), edge(high) - 1};
}

}  // namespace burnish
