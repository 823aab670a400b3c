#include <burnish/material/sgd/fitted_shadowing.h>

#include <unsupported/Eigen/NonLinearOptimization>

#include <limits>
#include <vector>

namespace burnish {
namespace {

constexpr int kAngles = 360;

double angle(int i) { return (i + 0.5) * std::numbers::pi / 2 / kAngles; }

std::vector<double> smith_G1(const ShiftedGamma& slopes) {
    std::vector<double> G1;
    for (int i = 0; i < kAngles; ++i) G1.push_back(slopes.G1(1 / std::tan(angle(i))));
    return G1;
}

double mean_square(const FittedShadowing& shadowing, const std::vector<double>& exact) {
    double sum = 0;
    for (int i = 0; i < kAngles; ++i) {
        const double d = shadowing.G1(static_cast<float>(angle(i))) - exact[static_cast<size_t>(i)];
        sum += d * d;
    }
    return sum / kAngles;
}

/// What Levenberg-Marquardt sees: residuals over the angles, of (ln lambda, ln R, ln k), in which the valley is straighter than
/// in (lambda, c, k).
struct Residuals {
    const std::vector<double>& exact;

    int values() const { return kAngles; }
    int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const {
        const double lambda = std::exp(x[0]), reach = std::exp(x[1]), k = std::exp(x[2]), log = std::log1p(1 / lambda);
        for (int i = 0; i < kAngles; ++i) {
            const double q = std::max(1 - (std::numbers::pi / 2 - angle(i)) / reach, 0.0);
            residuals[i] = 1 - lambda * std::expm1(log * std::pow(q, k)) - exact[static_cast<size_t>(i)];
        }
        return 0;
    }
    int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
        constexpr double kStep = 1e-6;
        Eigen::VectorXd above(kAngles), below(kAngles);
        for (int j = 0; j < 3; ++j) {
            (*this)(x + kStep * Eigen::VectorXd::Unit(3, j), above);
            (*this)(x - kStep * Eigen::VectorXd::Unit(3, j), below);
            jacobian.col(j) = (above - below) / (2 * kStep);
        }
        return 0;
    }
};

ShadowingFit polished(Eigen::VectorXd x, const std::vector<double>& exact) {
    Residuals residuals{exact};
    Eigen::LevenbergMarquardt<Residuals> solver(residuals);
    solver.minimize(x);
    const double lambda = std::exp(x[0]), k = std::exp(x[2]);
    const double log_c = std::log(std::log1p(1 / lambda)) - k * x[1];
    const double c = std::exp(std::min(log_c, std::log(static_cast<double>(std::numeric_limits<float>::max()))));
    const double l2 = mean_square(FittedShadowing(lambda, c, k), exact);
    return {lambda, c, k, std::isfinite(l2) ? l2 : std::numeric_limits<double>::infinity()};
}

}  // namespace

ShadowingFit fit_g1(double alpha, double p) {
    const ShiftedGamma slopes(alpha, p);
    const std::vector<double> exact = smith_G1(slopes);
    ShadowingFit best{1, 1, 1, std::numeric_limits<double>::infinity()};
    for (const double lambda : {0.01, 3.0})
        for (const double k : {1.5, 5.0, 25.0})
            for (const double slopes_wide : {3.0, 10.0, 100.0}) {
                const double reach = std::min(slopes_wide * slopes.mean_slope(), 1.4);
                const ShadowingFit fit = polished(Eigen::Vector3d(std::log(lambda), std::log(reach), std::log(k)), exact);
                if (fit.l2 < best.l2) best = fit;
            }
    return best;
}

double shadowing_error(const FittedShadowing& shadowing, const ShiftedGamma& slopes) {
    return mean_square(shadowing, smith_G1(slopes));
}

}  // namespace burnish
