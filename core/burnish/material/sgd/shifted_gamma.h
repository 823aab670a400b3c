// The shifted gamma distribution of microfacet slopes: a sharp peak on an exponential tail, as measured materials have it.
//
//     P22(x) = K e^(-(alpha^2 + x) / alpha) / (alpha^2 + x)^p,   x = tan^2 theta, the squared slope; integral of P22 dx = 1
//     K = alpha^(p - 1) / Gamma(1 - p, alpha),   D(theta) = P22(tan^2 theta) / (pi cos^4 theta)
//     S(x) = Gamma(1 - p, alpha + x / alpha) / Gamma(1 - p, alpha), the share of the slopes beyond x
//
// Source: Bagher, Soler & Holzschuch 2012; Bandwidth, V.3.2 (whose text normalises to 1 / pi, and whose boxed formula to 1).
// For p < 1 most slopes lie near sqrt(alpha), the tail's end; for p > 1 near alpha, where the peak is.
#pragma once

#include <cmath>

namespace burnish {

/// Gamma(s, x) for any s and x > 0, to 1e-12 relative: p > 1 needs orders below zero.
double upper_gamma(double s, double x);

/// One colour channel's slopes.
class ShiftedGamma {
public:
    /// alpha > 0, p >= 0.
    ShiftedGamma(double alpha, double p) : ShiftedGamma(alpha * alpha, alpha, p) {}

    /// Much the same, convolved with Gaussian slopes of density e^(-x / variance): the peak ends at alpha^2 + variance and the tail
    /// falls like e^(-x / (alpha + variance)).
    ShiftedGamma blurred(double variance) const { return {m_shift + variance, m_decay + variance, m_p}; }

    /// P22(x), x >= 0: density of squared slopes.
    double density(double x) const { return std::exp(m_log_scale - x / m_decay - m_p * std::log(m_shift + x)); }
    /// S(x), the share of the slopes steeper than sqrt(x).
    double share_beyond(double x) const;
    /// Mean of tan theta over the slopes.
    double mean_slope() const;

    /// Smith's Lambda(theta) at cot theta > 0: integral of (r tan theta - 1) P2(r) dr beyond r = cot theta, where P2 is the
    /// density of the slope along one axis. To 1e-8.
    double lambda(double cot_theta) const;
    /// 1 / (1 + Lambda).
    double G1(double cot_theta) const { return cot_theta > 0 ? 1 / (1 + lambda(cot_theta)) : 0; }

    /// P22(x) = exp(log_scale - x / decay) / (shift + x)^p.
    double shift() const { return m_shift; }
    double decay() const { return m_decay; }
    double p() const { return m_p; }
    double log_scale() const { return m_log_scale; }

private:
    ShiftedGamma(double shift, double decay, double p);

    double m_shift, m_decay, m_p, m_log_scale;
};

}  // namespace burnish
