#include <burnish/fit/slices/least_squares.h>

#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

constexpr double kInside = 1e-4;  // starts keep this share of a range away from its ends, where the sine is flat

/// The free numbers as angles t.
class Angles {
public:
    Angles(std::span<const SearchRange> ranges, std::span<const double> start)
        : m_ranges(ranges), m_start(start.begin(), start.end()) {
        for (size_t i = 0; i < ranges.size(); ++i)
            if (!ranges[i].is_fixed()) m_free.push_back(i);
    }

    Eigen::VectorXd start() const {
        Eigen::VectorXd t(m_free.size());
        for (size_t k = 0; k < m_free.size(); ++k) {
            const double share = m_ranges[m_free[k]].share_of(m_start[m_free[k]]);
            t[static_cast<Eigen::Index>(k)] = std::asin(2 * std::clamp(share, kInside, 1 - kInside) - 1);
        }
        return t;
    }

    std::vector<double> numbers(const Eigen::VectorXd& t) const {
        std::vector<double> numbers = m_start;
        for (size_t k = 0; k < m_free.size(); ++k)
            numbers[m_free[k]] = m_ranges[m_free[k]].at(0.5 * (1 + std::sin(t[static_cast<Eigen::Index>(k)])));
        return numbers;
    }

private:
    std::span<const SearchRange> m_ranges;
    std::vector<double> m_start;
    std::vector<size_t> m_free;
};

/// What Eigen asks of a function.
struct Functor {
    using Scalar = double;
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    const Angles& angles;
    const Residuals& residuals;
    int count;

    int inputs() const { return static_cast<int>(angles.start().size()); }
    int values() const { return count; }
    int operator()(const Eigen::VectorXd& t, Eigen::VectorXd& values) const {
        std::vector<double> result;
        residuals(angles.numbers(t), result);
        values = Eigen::Map<const Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
        return 0;
    }
};

}  // namespace

double SearchRange::at(double share) const {
    return logarithmic ? min * std::pow(max / min, share) : min + (max - min) * share;
}

double SearchRange::share_of(double value) const {
    return logarithmic ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
}

std::vector<double> least_squares(std::span<const SearchRange> ranges, std::vector<double> start, const Residuals& residuals) {
    constexpr int kIterations = 60;
    constexpr double kLevel = 1e-6, kSettled = 1e-9, kStep = 1e-7, kFirstStep = 0.1;
    const Angles angles(ranges, start);
    Eigen::VectorXd t = angles.start();
    std::vector<double> first;
    residuals(start, first);
    if (t.size() == 0 || first.size() < static_cast<size_t>(t.size())) return start;
    using Differentiated = Eigen::NumericalDiff<Functor>;
    Differentiated functor(Functor{angles, residuals, static_cast<int>(first.size())}, kStep * kStep);
    Eigen::LevenbergMarquardt<Differentiated> optimiser(functor);
    optimiser.parameters.maxfev = kIterations;
    optimiser.parameters.factor = kFirstStep;
    optimiser.parameters.ftol = kLevel, optimiser.parameters.xtol = kSettled;
    optimiser.minimize(t);
    return angles.numbers(t);
}

}  // namespace burnish
