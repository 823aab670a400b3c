#include <burnish/material/lobes/abc_normals.h>

namespace burnish {

namespace {

constexpr float kFlat = 1e-4f;  // powers nearer to -1 than this integrate to a logarithm

/// Integral of u^-s du from 1 to e^L.
double power_integral(double s, double L) {
    const double q = 1 - s;
    return std::abs(q) < 1e-9 ? L : std::expm1(q * L) / q;
}

/// Integral of cos / (1 + B versine)^C dversine from 0, with L = ln(1 + B versine).
double projected_area(double B, double C, double L) {
    return ((1 + 1 / B) * power_integral(C, L) - power_integral(C - 1, L) / B) / B;
}

}  // namespace

double AbcNormals::peak(double B, double C) { return 1 / (2 * std::numbers::pi * projected_area(B, C, std::log1p(B))); }

AbcNormals::AbcNormals(float B, float C) : m_B(B), m_C(C) {
    const double L = std::log1p(static_cast<double>(B));
    m_peak = static_cast<float>(peak(B, C));
    m_drawn_peak = static_cast<float>(B / (2 * std::numbers::pi * power_integral(C, L)));
    const double versine = std::min(std::expm1(1 / std::max<double>(C, kFlat)) / B, 1.0), cosine = 1 - versine;
    const double slope = std::sqrt(versine * (1 + cosine)) / std::max(cosine, 1e-6);
    m_own_width = std::clamp(static_cast<float>(slope), kMinWidth, 1.0f);
}

Vec3f AbcNormals::sample(const Vec2f& u) const {
    const float L = std::log1p(m_B), q = std::abs(1 - m_C) < kFlat ? kFlat : 1 - m_C;
    const float log_u = std::log1p(u.x * std::expm1(q * L)) / q;  // of 1 + B versine
    const float versine = std::min(std::expm1(log_u) / m_B, 1.0f), phi = 2 * kPi * u.y;
    const float sine = std::sqrt(versine * (2 - versine));
    const Vec3f s(sine * std::cos(phi) / m_sx, sine * std::sin(phi) / m_sy, std::max(1 - versine, kMinCosine));
    return s / std::sqrt(s.length2());
}

float AbcNormals::border(float xi) const {
    const double B = m_B, all = projected_area(B, m_C, std::log1p(B));
    double low = std::log(1e-14), high = 0;  // logarithm of the versine
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        const double inside = projected_area(B, m_C, std::log1p(B * std::exp(middle))) / all;
        (1 - inside > xi ? low : high) = middle;
    }
    const double versine = std::exp(low), cosine = 1 - versine;
    return static_cast<float>(std::sqrt(versine * (1 + cosine)) / cosine / m_own_width);
}

}  // namespace burnish
