#include <burnish/light/traced/ray_bundle.h>

#include <algorithm>

namespace burnish {

constexpr float kGoldenAngle = 2.39996323f;

RayBundle::RayBundle(int rays) : m_part(1 / std::sqrt(static_cast<float>(rays))) {
    float square = 0;
    for (int i = 0; i < rays; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(rays), phi = kGoldenAngle * static_cast<float>(i);
        const float r2 = -2 * std::log(1 - u);
        m_places.push_back(Vec2f(std::cos(phi), std::sin(phi)) * std::sqrt(r2));
        square += r2 / static_cast<float>(rays);
    }
    for (Vec2f& place : m_places) place *= std::sqrt(2 * (1 - m_part * m_part) / square);
}

float RayBundle::mean_share(size_t i, float k) const {
    // Over a ring of the Gaussian's mass g is uniform, from `inner` down to `outer`.
    const double count = static_cast<double>(m_places.size()), outer = 1 - (static_cast<double>(i) + 1) / count,
                 inner = outer + 1 / count;
    return k > 0 ? static_cast<float>(std::max(1 - count * k * (std::atan(inner / k) - std::atan(outer / k)), 0.0)) : 1.0f;
}

Cone::Cone(const Vec3f& d, const Vec3f& up, float sigma)
    : m_frame(Frame::along(d, up)),
      m_up(up),
      m_sigma(sigma),
      m_peak(-1 / (2 * kPi * sigma * sigma * std::expm1(-2 / (sigma * sigma)))) {}

Vec3f Cone::direction(const Vec2f& place) const {
    const float versine = std::min(0.5f * place.length2() * m_sigma * m_sigma, 2.0f), length = place.length();
    if (!(length > 0)) return m_frame.n;
    const float sine = std::sqrt(versine * (2 - versine)) / length;
    const Vec3f d = m_frame.to_world({place.x * sine, place.y * sine, 1 - versine});
    return d - m_up * (2 * std::min(m_up.dot(d), 0.0f));
}

Vec2f Cone::squares(const Vec3f& d) const {
    const float versine = 0.5f * (d - m_frame.n).length2(), scale = 2 / (m_sigma * m_sigma);
    return Vec2f(versine, versine + 2 * m_up.dot(d) * m_up.dot(m_frame.n)) * scale;
}

float Cone::density(const Vec2f& squares) const { return m_peak * (std::exp(-0.5f * squares.x) + std::exp(-0.5f * squares.y)); }

}  // namespace burnish
