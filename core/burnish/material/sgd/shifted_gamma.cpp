#include <burnish/material/sgd/shifted_gamma.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace burnish {
namespace {

constexpr double kNothing = 40;  // exp(-40) of an integral is nothing
constexpr double kStep =
    0.25;  // of a logarithm: error exp(-pi^2 / step), as the integrands are analytic within pi/2 of the axis

/// Plain sums converge exponentially with 1 / step where an analytic integrand dies out at both ends, as all here do in a logarithm.
template <class F>
double trapezoid(double from, double to, double step, F integrand) {
    double sum = 0;
    for (double at = from; at < to; at += step) sum += integrand(at);
    return sum * step;
}

/// Of Smith's integral over x = cot^2 e^t, t = ln(1 + e^v), v evenly spaced; free of the distribution.
struct SmithNode {
    double stretch, kernel;  // e^t; (sqrt(e^t - 1) - acos(e^(-t/2))) e^t / pi dt
};

std::vector<SmithNode> smith_nodes() {
    constexpr double step = 0.4, longest = 60;
    std::vector<SmithNode> nodes;
    for (double v = -16; v < longest; v += step) {
        const double t = std::log1p(std::exp(v)), rise = std::sqrt(std::expm1(t));
        // sqrt(q^2 - 1) - acos(1 / q) = rise - atan(rise), which cancels where rise is small
        const double steep = rise < 1e-2 ? rise * rise * rise * (1.0 / 3 - rise * rise / 5) : rise - std::atan(rise);
        nodes.push_back({std::exp(t), steep / std::numbers::pi * step / (1 + std::exp(-v)) * std::exp(t)});
    }
    return nodes;
}

}  // namespace

double upper_gamma(double s, double x) {
    // t = x + e^y: integral of t^(s-1) e^-t dt
    return trapezoid(std::log(x) - kNothing, std::log(kNothing + 4 * std::abs(s)) + 1, kStep, [&](double y) {
        const double beyond = std::exp(y), t = x + beyond;
        return std::exp((s - 1) * std::log(t) - t) * beyond;
    });
}

ShiftedGamma::ShiftedGamma(double shift, double decay, double p) : m_shift(shift), m_decay(decay), m_p(p) {
    m_log_scale = (p - 1) * std::log(decay) - shift / decay - std::log(upper_gamma(1 - p, shift / decay));
}

double ShiftedGamma::share_beyond(double x) const {
    return upper_gamma(1 - m_p, (m_shift + x) / m_decay) / upper_gamma(1 - m_p, m_shift / m_decay);
}

double ShiftedGamma::mean_slope() const {
    const double from = std::log(m_shift) - kNothing, to = std::log(m_decay * kNothing) + 1;
    return trapezoid(from, to, kStep, [&](double y) { return density(std::exp(y)) * std::exp(1.5 * y); });
}

double ShiftedGamma::lambda(double cot_theta) const {
    // With the azimuth integrated, slopes s > cot see (s / cot) sin phi - phi, cos phi = cot / s, of pi.
    static const std::vector<SmithNode> nodes = smith_nodes();
    const double cot2 = cot_theta * cot_theta, last = cot2 + m_decay * kNothing;
    double sum = 0;
    for (const SmithNode& node : nodes) {
        const double x = cot2 * node.stretch;
        if (x > last) break;
        sum += node.kernel * density(x);
    }
    return sum * cot2;
}

}  // namespace burnish
