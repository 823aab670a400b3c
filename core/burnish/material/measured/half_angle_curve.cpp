#include <burnish/material/measured/half_angle_curve.h>
#include <burnish/material/measured/half_difference.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>

namespace burnish {

HalfAngleCurve::HalfAngleCurve(std::vector<std::pair<float, Color3f>> points) : m_points(std::move(points)) {
    for (auto& [at, f] : m_points) at = std::acos(std::clamp(at, 0.0f, 1.0f));
    std::ranges::stable_sort(m_points, {}, &std::pair<float, Color3f>::first);
}

Color3f HalfAngleCurve::eval(const Vec3f& wo, const Vec3f& wi) const {
    if (!above_surface(wo, wi)) return Color3f(0);
    const float theta_h = half_difference(wo, wi).theta_h;
    const auto above = std::ranges::upper_bound(m_points, theta_h, {}, &std::pair<float, Color3f>::first);
    if (above == m_points.begin()) return m_points.front().second;
    if (above == m_points.end()) return m_points.back().second;
    const auto& [first, f_first] = *(above - 1);
    const auto& [second, f_second] = *above;
    const float share = (theta_h - first) / (second - first);
    return f_first * (1 - share) + f_second * share;
}

std::vector<BrdfSample> HalfAngleCurve::samples() const {
    std::vector<BrdfSample> result;
    for (const auto& [theta_h, f] : m_points) {
        const Vec3f along(std::sin(theta_h), 0, std::cos(theta_h));
        result.push_back({along, along, f});
    }
    return result;
}

}  // namespace burnish
