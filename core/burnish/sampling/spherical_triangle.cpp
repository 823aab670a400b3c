#include <burnish/sampling/spherical_triangle.h>

#include <algorithm>

namespace burnish {
namespace {

using Imath::V3d;

/// The part of v perpendicular to unit vector n, as a unit vector; zero where there is none.
V3d across(const V3d& v, const V3d& n) {
    const V3d part = v - n * n.dot(v);
    const double length = part.length();
    return length > 0 ? part / length : V3d(0, 0, 0);
}

/// Cosine of the angle at corner `at` between the edges to two others.
double cosine_at(const V3d& at, const V3d& one, const V3d& other) {
    return std::clamp(across(one, at).dot(across(other, at)), -1.0, 1.0);
}

double sine_of(double cosine) { return std::sqrt(std::max(0.0, 1 - cosine * cosine)); }

}  // namespace

SphericalTriangle::SphericalTriangle(const Vec3f& a, const Vec3f& b, const Vec3f& c)
    : m_a(V3d(a).normalized()), m_b(V3d(b).normalized()), m_c(V3d(c).normalized()) {
    const double volume = std::fabs((m_b - m_a).cross(m_c - m_a).dot(m_a));
    m_solid_angle = 2 * std::atan2(volume, 1 + m_a.dot(m_b) + m_b.dot(m_c) + m_c.dot(m_a));
}

Vec3f SphericalTriangle::sample(const Vec2f& u) const {
    const double cos_a = cosine_at(m_a, m_b, m_c), alpha = std::acos(cos_a), sin_a = std::sin(alpha);
    const double part = static_cast<double>(u.x) * m_solid_angle - alpha;  // the two other angles of what is cut off, less pi
    const double sine = std::sin(part), cosine = std::cos(part);
    const double k1 = cosine - cos_a, k2 = sine + sin_a * m_a.dot(m_b);
    const double below = (sine * k2 + cosine * k1) * sin_a;
    const double cos_b = below != 0 ? std::clamp(((cosine * k2 - sine * k1) * cos_a - k2) / below, -1.0, 1.0) : 1.0;
    const V3d cut = m_a * cos_b + across(m_c, m_a) * sine_of(cos_b);
    const double along = 1 - static_cast<double>(u.y) * (1 - cut.dot(m_b));
    return Vec3f((m_b * along + across(cut, m_b) * sine_of(along)).normalized());
}

}  // namespace burnish
