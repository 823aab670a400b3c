#include <burnish/base/parallel.h>
#include <burnish/fit/search/l1_polish.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr size_t kBatch = 4096;
constexpr int kMaxSteps = 80;
constexpr double kSmooth[] = {1, 0.3, 0.1};  // epsilon over the typical residual
constexpr double kEnough = 1e-5;             // relative gain below which a stage ends
constexpr double kLeastDamping = 1e-6, kFirstDamping = 1e-2, kMostDamping = 1e8;

/// Sums over samples at one mixture.
struct Normal {
    Eigen::MatrixXd matrix;    // slopes squared, w / |r| each
    Eigen::VectorXd gradient;  // of the error, downhill
    Eigen::MatrixXd scatter;   // slopes squared, w^2 each: the gradient's variance

    Normal& operator+=(const Normal& other) {
        matrix += other.matrix, gradient += other.gradient, scatter += other.scatter;
        return *this;
    }
};

/// Where the error comes from at one mixture.
class NormalEquations {
public:
    NormalEquations(const LobeMixture& mixture, const std::vector<Unknown>& list, const TransferSamples& samples,
                    const std::vector<float>& target, double smooth)
        : m_mixture(mixture), m_unknowns(list), m_samples(samples), m_target(target) {
        for (size_t j = 0; j < target.size(); ++j) m_mean += static_cast<double>(samples.weight[j]) * std::abs(target[j]);
        m_level = m_mean > 0 ? smooth * mixture.error / m_mean : 0;
    }

    /// In batches that are summed in their order, whichever thread did them.
    Normal sums() const {
        const size_t batches = (m_samples.size() + kBatch - 1) / kBatch;
        std::vector<Normal> parts(batches);
        for_each_index(static_cast<int>(batches), [&](int i) {
            const size_t begin = static_cast<size_t>(i) * kBatch;
            parts[static_cast<size_t>(i)] = batch(begin, std::min(begin + kBatch, m_samples.size()));
        });
        for (size_t i = 1; i < batches; ++i) parts[0] += parts[i];
        return parts[0];
    }

private:
    Normal batch(size_t begin, size_t end) const {
        const MixtureSlopes slopes = mixture_slopes(m_mixture, m_unknowns, m_samples, begin, end);
        const Eigen::Index rows = slopes.model.size();
        Eigen::VectorXd pull(rows), weight(rows), square(rows);
        for (Eigen::Index j = 0; j < rows; ++j) {
            const size_t s = begin + static_cast<size_t>(j);
            const double residual = m_target[s] - slopes.model[j];
            const double typical = m_level * (std::abs(m_target[s]) + 0.1 * m_mean);
            weight[j] = m_samples.weight[s] / std::max({std::abs(residual), typical, 1e-30});
            pull[j] = weight[j] * residual;
            square[j] = static_cast<double>(m_samples.weight[s]) * m_samples.weight[s];
        }
        const Eigen::MatrixXd& slope = slopes.slope;
        return {slope.transpose() * (weight.asDiagonal() * slope), slope.transpose() * pull,
                slope.transpose() * (square.asDiagonal() * slope)};
    }

    const LobeMixture& m_mixture;
    const std::vector<Unknown>& m_unknowns;
    const TransferSamples& m_samples;
    const std::vector<float>& m_target;
    double m_mean = 0, m_level;
};

class Polish {
public:
    Polish(LobeMixture start, const TransferSamples& samples, const std::vector<float>& target)
        : m_best(std::move(start)), m_samples(samples), m_target(target), m_unknowns(unknowns(m_best)) {
        m_best.error = mixture_error(m_best, samples, target);
    }

    LobeMixture run(const Progress& progress) {
        int steps = 0;
        for (const double smooth : kSmooth) {
            for (double gain = 1; gain > kEnough && steps < kMaxSteps && m_best.error > 0; ++steps) {
                progress.report("polish", static_cast<float>(steps) / kMaxSteps);
                const double before = m_best.error;
                if (!step(smooth)) break;
                gain = 1 - m_best.error / before;
            }
        }
        return m_best;
    }

private:
    /// Tries dampings until the error falls; false at the bottom.
    bool step(double smooth) {
        const Normal normal = NormalEquations(m_best, m_unknowns, m_samples, m_target, smooth).sums();
        for (; m_damping < kMostDamping; m_damping *= 8) {
            LobeMixture next = moved(normal);
            next.error = mixture_error(next, m_samples, m_target);
            if (!(next.error < m_best.error)) continue;
            m_best = std::move(next);
            m_damping = std::max(m_damping / 8, kLeastDamping);
            return true;
        }
        m_damping = kFirstDamping;
        return false;
    }

    /// One damped step that stays within the ranges; numbers that would leave from the border stay out of it.
    LobeMixture moved(const Normal& normal) const {
        std::vector<int> free;
        for (size_t u = 0; u < m_unknowns.size(); ++u) {
            const double at = m_unknowns[u].get(m_best), down = normal.gradient[static_cast<int>(u)];
            if (!((at <= 0 && down < 0) || (at >= 1 && down > 0))) free.push_back(static_cast<int>(u));
        }
        Eigen::MatrixXd matrix = normal.matrix(free, free);
        matrix.diagonal() *= 1 + m_damping;
        matrix.diagonal().array() += 1e-12 * (1 + normal.matrix.diagonal().maxCoeff());
        const Eigen::VectorXd change = matrix.ldlt().solve(normal.gradient(free));
        LobeMixture next = m_best;
        for (size_t i = 0; i < free.size(); ++i) {
            const Unknown& unknown = m_unknowns[static_cast<size_t>(free[i])];
            unknown.set(next, std::clamp(unknown.get(m_best) + change[static_cast<int>(i)], 0.0, 1.0));
        }
        return next;
    }

    LobeMixture m_best;
    const TransferSamples& m_samples;
    const std::vector<float>& m_target;
    const std::vector<Unknown> m_unknowns;
    double m_damping = kFirstDamping;
};

}  // namespace

LobeMixture polished(LobeMixture mixture, const TransferSamples& samples, const std::vector<float>& target,
                     const Progress& progress) {
    return Polish(std::move(mixture), samples, target).run(progress);
}

std::vector<double> standard_errors(const LobeMixture& mixture, const TransferSamples& samples,
                                    const std::vector<float>& target) {
    const std::vector<Unknown> list = unknowns(mixture);
    const Normal normal = NormalEquations(mixture, list, samples, target, 1).sums();
    // Variance of the zero of a sum: the sandwich of its slope's inverse and its own variance (Huber 1967).
    const Eigen::MatrixXd inverse = normal.matrix.completeOrthogonalDecomposition().pseudoInverse();
    const Eigen::MatrixXd variance = inverse * normal.scatter * inverse;
    std::vector<double> errors;
    for (size_t u = 0; u < list.size(); ++u) {
        const int i = static_cast<int>(u);
        const bool shape = list[u].kind == Unknown::Kind::shape;
        const bool ratio = shape && mixture.spaces[list[u].lobe].shape[list[u].shape].logarithmic;
        const double range = ratio ? std::log(list[u].range.max / list[u].range.min) : list[u].range.max - list[u].range.min;
        errors.push_back(normal.matrix(i, i) > 0 ? range * std::sqrt(std::max(0.0, variance(i, i)))
                                                 : std::numeric_limits<double>::infinity());
    }
    return errors;
}

}  // namespace burnish
