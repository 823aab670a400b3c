#include <burnish/fit/slices/bounded_least_squares.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace burnish {

namespace {

/// The unknowns scaled to columns of length 1, which makes H a matrix of correlations.
BoundedLeastSquares scaled(const BoundedLeastSquares& problem, Eigen::VectorXd& scale) {
    constexpr double kRidge = 1e-14;
    const Eigen::VectorXd length = problem.H.diagonal().cwiseSqrt();
    scale = (length.array() > 1e-150).select(length.cwiseInverse(), 0.0);
    BoundedLeastSquares result = problem;
    result.H = scale.asDiagonal() * problem.H * scale.asDiagonal();
    result.H.diagonal().array() += kRidge;
    result.g = scale.cwiseProduct(problem.g);
    result.bounds = problem.bounds * scale.asDiagonal();
    return result;
}

/// Multipliers of the bounds, >= 0: minimum of y^T M y / 2 - d^T y.
Eigen::VectorXd hildreth(const Eigen::MatrixXd& M, const Eigen::VectorXd& d) {
    constexpr int kSweeps = 500;
    constexpr double kSettled = 1e-12;
    Eigen::VectorXd y = Eigen::VectorXd::Zero(d.size());
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        double change = 0;
        for (int i = 0; i < y.size(); ++i) {
            if (M(i, i) <= 0) continue;
            const double next = std::max(0.0, y[i] + (d[i] - M.row(i).dot(y)) / M(i, i));
            change = std::max(change, std::abs(next - y[i]) * std::sqrt(M(i, i)));
            y[i] = next;
        }
        if (change < kSettled) break;
    }
    return y;
}

}  // namespace

Eigen::VectorXd solve(const BoundedLeastSquares& problem) {
    constexpr double kSlack = 1e-12;
    Eigen::VectorXd scale;
    const BoundedLeastSquares s = scaled(problem, scale);
    const Eigen::LDLT<Eigen::MatrixXd> H(s.H);
    const Eigen::VectorXd free = H.solve(s.g);
    const Eigen::VectorXd lacking = s.limits - s.bounds * free;
    if (lacking.size() == 0 || lacking.maxCoeff() <= kSlack * (1 + free.norm())) return scale.cwiseProduct(free);
    const Eigen::MatrixXd to_bounds = H.solve(s.bounds.transpose());
    const Eigen::VectorXd y = hildreth(s.bounds * to_bounds, lacking);
    return scale.cwiseProduct(free + to_bounds * y);
}

}  // namespace burnish
