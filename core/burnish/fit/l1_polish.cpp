#include <burnish/base/parallel.h>
#include <burnish/fit/l1_polish.h>
#include <burnish/fit/lobe_basis.h>
#include <burnish/material/any_model.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burnish {
namespace {

constexpr size_t kBatch = 4096;
constexpr double kDifference = 2e-4;  // of a parameter's range, for derivatives by the shape
constexpr int kMaxSteps = 80;
constexpr double kSmooth[] = {1, 0.3, 0.1};  // epsilon over the typical residual
constexpr double kEnough = 1e-5;             // relative gain below which a stage ends
constexpr double kMaxDamping = 1e8;

/// One free number in units of its range.
struct Unknown {
    enum class Kind { kd, strength, r0, shape } kind;
    size_t lobe = 0, shape = 0;
    NumberRange range{0, 1};
};

/// Sums of a batch of samples: normal equations of the re-weighted squares.
struct Normal {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd gradient;
};

class Polish {
public:
    Polish(const LobeMixture& start, const TransferSamples& samples, const std::vector<float>& target)
        : m_best(start), m_samples(samples), m_target(target) {
        for (size_t j = 0; j < target.size(); ++j) m_mean += static_cast<double>(samples.weight[j]) * target[j];
        list_unknowns();
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
    void list_unknowns() {
        using Kind = Unknown::Kind;
        const auto add = [&](Unknown unknown) {
            if (unknown.range.max > unknown.range.min) m_unknowns.push_back(unknown);
        };
        if (m_best.side == Side::reflection) add({Kind::kd, 0, 0, m_best.kd_range});
        for (size_t n = 0; n < m_best.lobes.size(); ++n) {
            const LobeSpace& space = m_best.spaces[n];
            add({Kind::strength, n, 0, space.strength});
            if (space.has_fresnel) add({Kind::r0, n, 0, space.r0});
            for (size_t i = 0; i < space.shape.size(); ++i) add({Kind::shape, n, i, space.shape[i].range});
        }
    }

    double get(const LobeMixture& mixture, const Unknown& unknown) const {
        const auto unit = [&](double value) { return (value - unknown.range.min) / (unknown.range.max - unknown.range.min); };
        switch (unknown.kind) {
            case Unknown::Kind::kd: return unit(mixture.kd);
            case Unknown::Kind::strength: return unit(mixture.lobes[unknown.lobe].strength);
            case Unknown::Kind::r0: return unit(mixture.lobes[unknown.lobe].fresnel.eta.x);
            case Unknown::Kind::shape: break;
        }
        const ShapeParameter& parameter = mixture.spaces[unknown.lobe].shape[unknown.shape];
        return parameter.unit(parameter.get(mixture.lobes[unknown.lobe]));
    }

    void set(LobeMixture& mixture, const Unknown& unknown, double unit) const {
        const float value = static_cast<float>(unknown.range.min + unit * (unknown.range.max - unknown.range.min));
        switch (unknown.kind) {
            case Unknown::Kind::kd: mixture.kd = value; break;
            case Unknown::Kind::strength: mixture.lobes[unknown.lobe].strength = value; break;
            case Unknown::Kind::r0: mixture.lobes[unknown.lobe].fresnel.eta = Color3f(value); break;
            case Unknown::Kind::shape: set_shape(mixture.lobes[unknown.lobe], unknown, unit); break;
        }
    }

    void set_shape(LobeParameters& lobe, const Unknown& unknown, double unit) const {
        const LobeSpace& space = m_best.spaces[unknown.lobe];
        space.shape[unknown.shape].set(lobe, space.shape[unknown.shape].at(unit));
        if (const float own_width = prepare(lobe); own_width > 0) lobe.mx = lobe.my = own_width;
    }

    /// Tries dampings until the error falls; false at the bottom.
    bool step(double smooth) {
        const Normal normal = normal_equations(smooth);
        for (; m_damping < kMaxDamping; m_damping *= 8) {
            LobeMixture next = moved(normal);
            next.error = mixture_error(next, m_samples, m_target);
            if (!(next.error < m_best.error)) continue;
            m_best = std::move(next);
            m_damping = std::max(m_damping / 8, 1e-6);
            return true;
        }
        m_damping = 1e-2;
        return false;
    }

    /// One damped step that stays within the ranges; numbers that would leave from the border stay out of it.
    LobeMixture moved(const Normal& normal) const {
        const size_t count = m_unknowns.size();
        std::vector<int> free;
        for (size_t u = 0; u < count; ++u) {
            const double at = get(m_best, m_unknowns[u]), down = normal.gradient[static_cast<int>(u)];
            if (!((at <= 0 && down < 0) || (at >= 1 && down > 0))) free.push_back(static_cast<int>(u));
        }
        Eigen::MatrixXd matrix = normal.matrix(free, free);
        matrix.diagonal() *= 1 + m_damping;
        matrix.diagonal().array() += 1e-12 * (1 + normal.matrix.diagonal().maxCoeff());
        const Eigen::VectorXd change = matrix.ldlt().solve(normal.gradient(free));
        LobeMixture next = m_best;
        for (size_t i = 0; i < free.size(); ++i) {
            const Unknown& unknown = m_unknowns[static_cast<size_t>(free[i])];
            set(next, unknown, std::clamp(get(m_best, unknown) + change[static_cast<int>(i)], 0.0, 1.0));
        }
        return next;
    }

    Normal normal_equations(double smooth) const {
        const size_t batches = (m_samples.size() + kBatch - 1) / kBatch;
        std::vector<Normal> parts(batches);
        for_each_index(static_cast<int>(batches), [&](int i) {
            const size_t begin = static_cast<size_t>(i) * kBatch;
            parts[static_cast<size_t>(i)] = batch_equations(smooth, begin, std::min(begin + kBatch, m_samples.size()));
        });
        for (size_t i = 1; i < batches; ++i) {
            parts[0].matrix += parts[i].matrix;
            parts[0].gradient += parts[i].gradient;
        }
        return parts[0];
    }

    Normal batch_equations(double smooth, size_t begin, size_t end) const {
        const int count = static_cast<int>(m_unknowns.size()), rows = static_cast<int>(end - begin);
        Eigen::MatrixXd slope(rows, count);
        Eigen::VectorXd model(rows);
        for (int j = 0; j < rows; ++j) model[j] = m_best.kd / kPi * m_samples.cosine[begin + static_cast<size_t>(j)];
        if (m_best.side == Side::transmission) model.setZero();
        std::vector<Eigen::VectorXd> lobes;
        for (size_t n = 0; n < m_best.lobes.size(); ++n) {
            lobes.push_back(lobe_values(m_best.lobes[n], n, begin, end));
            model += lobes.back();
        }
        for (int u = 0; u < count; ++u) slope.col(u) = slope_by(m_unknowns[static_cast<size_t>(u)], lobes, begin, end);
        const double level = m_mean > 0 ? m_best.error / m_mean : 0;
        Eigen::VectorXd residual(rows), weight(rows);
        for (int j = 0; j < rows; ++j) {
            const size_t s = begin + static_cast<size_t>(j);
            residual[j] = m_target[s] - model[j];
            const double typical = smooth * level * (std::abs(m_target[s]) + 0.1 * m_mean);
            weight[j] = m_samples.weight[s] / std::max({std::abs(residual[j]), typical, 1e-30});
        }
        const Eigen::MatrixXd weighted = weight.asDiagonal() * slope;
        return {slope.transpose() * weighted, weighted.transpose() * residual};
    }

    /// p of a lobe with its own strength and r0.
    Eigen::VectorXd lobe_values(const LobeParameters& lobe, size_t n, size_t begin, size_t end) const {
        thread_local LobeBasis basis;
        const double r0 = m_best.spaces[n].has_fresnel ? lobe.fresnel.eta.x : 0;
        lobe_basis(lobe, {r0, r0}, m_samples, begin, end, basis);
        return lobe.strength * Eigen::Map<Eigen::VectorXf>(basis.low.data(), static_cast<int>(end - begin)).cast<double>();
    }

    Eigen::VectorXd slope_by(const Unknown& unknown, const std::vector<Eigen::VectorXd>& lobes, size_t begin,
                             size_t end) const {
        const double range = unknown.range.max - unknown.range.min;
        const size_t n = unknown.lobe;
        if (unknown.kind == Unknown::Kind::kd)
            return range / kPi *
                   Eigen::Map<const Eigen::VectorXf>(&m_samples.cosine[begin], static_cast<int>(end - begin)).cast<double>();
        LobeParameters lobe = m_best.lobes[n];
        if (unknown.kind == Unknown::Kind::strength) {
            if (lobe.strength > 0) return range / lobe.strength * lobes[n];
            lobe.strength = 1;
            return range * lobe_values(lobe, n, begin, end);
        }
        if (unknown.kind == Unknown::Kind::r0) {
            lobe.fresnel.eta = Color3f(static_cast<float>(unknown.range.min));
            const Eigen::VectorXd low = lobe_values(lobe, n, begin, end);
            lobe.fresnel.eta = Color3f(static_cast<float>(unknown.range.max));
            return lobe_values(lobe, n, begin, end) - low;
        }
        const double at = get(m_best, unknown), change = at > 0.5 ? -kDifference : kDifference;
        set_shape(lobe, unknown, at + change);
        return (lobe_values(lobe, n, begin, end) - lobes[n]) / change;
    }

    LobeMixture m_best;
    const TransferSamples& m_samples;
    const std::vector<float>& m_target;
    std::vector<Unknown> m_unknowns;
    double m_mean = 0, m_damping = 1e-2;
};

}  // namespace

int LobeMixture::parameters() const {
    const int diffuse = side == Side::reflection && kd_range.max > kd_range.min ? 1 : 0;
    return std::accumulate(spaces.begin(), spaces.end(), diffuse,
                           [](int sum, const LobeSpace& space) { return sum + space.parameters(); });
}

Material LobeMixture::material() const {
    Material material;
    material.kd = Color3f(kd);
    material.lobes = lobes;
    return material;
}

std::vector<float> mixture_transfer(const LobeMixture& mixture, const TransferSamples& samples) {
    return grey(model_transfer(mixture.material(), samples, mixture.side));
}

double mixture_error(const LobeMixture& mixture, const TransferSamples& samples, const std::vector<float>& target) {
    const std::vector<float> model = mixture_transfer(mixture, samples);
    double error = 0;
    for (size_t j = 0; j < target.size(); ++j) error += samples.weight[j] * std::abs(target[j] - model[j]);
    return error;
}

LobeMixture polished(LobeMixture mixture, const TransferSamples& samples, const std::vector<float>& target,
                     const Progress& progress) {
    return Polish(mixture, samples, target).run(progress);
}

}  // namespace burnish
