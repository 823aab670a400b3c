// The four numbers that stand for Smith's G1 of a shifted gamma distribution where a table is too much.
//
//     G1(theta) = 1 + lambda (1 - e^(c (theta - theta0)^k)) above theta0, else 1
//     theta0 = pi/2 - R,   R = (ln(1 + 1/lambda) / c)^(1/k), so that G1(pi/2) = 0
//
// Source: Bandwidth, eq. V.3. Evaluated as 1 - lambda expm1(ln(1 + 1/lambda) q^k), q = (theta - theta0) / R in [0, 1], as published c
// exceed the range of float, and k and lambda reach 855 and 1.5e7.
#pragma once

#include <burnish/material/sgd/shifted_gamma.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {

class FittedShadowing {
public:
    FittedShadowing(double lambda, double c, double k)
        : m_lambda(static_cast<float>(lambda)), m_k(static_cast<float>(k)), m_log(static_cast<float>(std::log1p(1 / lambda))) {
        m_inv_reach = static_cast<float>(std::exp((std::log(c) - std::log(std::log1p(1 / lambda))) / k));
    }

    /// G1 at the angle theta in [0, pi/2].
    float G1(float theta) const {
        const float q = 1 - (std::numbers::pi_v<float> / 2 - theta) * m_inv_reach;
        if (q <= 0) return 1;
        return std::clamp(1 - m_lambda * std::expm1(m_log * std::pow(q, m_k)), 0.0f, 1.0f);
    }

private:
    float m_lambda, m_k, m_log, m_inv_reach;
};

struct ShadowingFit {
    double lambda, c, k;
    double l2;  // mean square of the difference to Smith's G1 over theta in [0, pi/2]
};

/// The (lambda, c, k) closest to Smith's G1 of these slopes, c within the range of float.
ShadowingFit fit_g1(double alpha, double p);
/// Mean square of the difference between `shadowing` and Smith's G1 over theta in [0, pi/2].
double shadowing_error(const FittedShadowing& shadowing, const ShiftedGamma& slopes);

}  // namespace burnish
