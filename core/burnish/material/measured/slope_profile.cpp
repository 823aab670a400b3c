#include <burnish/material/measured/slope_profile.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double kStep = static_cast<double>(SlopeProfile::kLast) / (SlopeProfile::kNodes - 1);

double rho_of(double s) { return std::sqrt(std::expm1(s)); }

}  // namespace

SlopeProfile::SlopeProfile() : SlopeProfile([](double) { return 0.0; }) {}

SlopeProfile::SlopeProfile(const std::function<double(double)>& density) {
    // rho drho dphi = (1 + rho^2) / 2 ds dphi
    for (int i = 0; i < kNodes; ++i)
        m_q[static_cast<size_t>(i)] = static_cast<float>(density(rho_of(i * kStep)) * std::exp(i * kStep));
    m_q.back() = 0;
    if (*std::ranges::max_element(m_q) <= 0)
        for (int i = 0; i < kNodes; ++i) m_q[static_cast<size_t>(i)] = static_cast<float>(std::exp(-i * kStep));
    integrate();
}

void SlopeProfile::integrate() {
    m_below[0] = 0;
    for (size_t i = 1; i < kNodes; ++i) m_below[i] = m_below[i - 1] + 0.5 * kStep * (m_q[i - 1] + m_q[i]);
    const double whole = m_below.back();
    for (float& q : m_q) q = static_cast<float>(q / whole);
    for (double& share : m_below) share /= whole;
}

float SlopeProfile::q(float s) const {
    if (!(s < kLast)) return 0;
    const float at = s / static_cast<float>(kStep);
    const auto node = std::min(static_cast<size_t>(at), static_cast<size_t>(kNodes - 2));
    const float part = at - static_cast<float>(node);
    return m_q[node] * (1 - part) + m_q[node + 1] * part;
}

float SlopeProfile::border(float xi) const {
    const double within = 1 - static_cast<double>(xi);
    const auto above = std::ranges::upper_bound(m_below, within);
    const size_t node = std::clamp<size_t>(static_cast<size_t>(above - m_below.begin()), 1, kNodes - 1) - 1;
    // share = a x + b x^2 of the way through the interval, q being linear there
    const double left = within - m_below[node], a = m_q[node] * kStep, b = 0.5 * (m_q[node + 1] - m_q[node]) * kStep;
    const double root = std::sqrt(std::max(a * a + 4 * b * left, 0.0));
    const double part = a + root > 0 ? std::clamp(2 * left / (a + root), 0.0, 1.0) : 1.0;
    return static_cast<float>(rho_of((static_cast<double>(node) + part) * kStep));
}

}  // namespace burnish
