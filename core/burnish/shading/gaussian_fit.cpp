#include <burnish/shading/gaussian_fit.h>

#include <burnish/material/lobes/microfacet.h>
#include <burnish/shading/lobe_image.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace burnish {
namespace {

using Eigen::ArrayXf;
using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;
using Plane = Eigen::Map<const ArrayXf>;

Plane plane(const std::vector<float>& values) { return {values.data(), static_cast<Index>(values.size())}; }

constexpr float kEnergy = 30;     // how much a wrong sum of weights costs, against the squared residual
constexpr float kRidge = 3e-4f;   // keeps weights small where Gaussians nearly coincide
constexpr float kEnough = 1e-3f;  // a step that gains less of the cost is the last
constexpr float kWidest = 1.0f;   // rad

class Fit {
public:
    Fit(const LobeQuadrature& lobe, const Vec3f& wo, bool in_plane)
        : m_lobe(lobe),
          m_wo(wo),
          m_unknowns(in_plane ? 2 : 3),
          m_x(plane(lobe.x)),
          m_y(plane(lobe.y)),
          m_z(plane(lobe.z)),
          m_root_area(plane(lobe.root_area)),
          m_albedo(luminance(lobe.albedo)) {
        m_luminance = 0.2126f * plane(lobe.value[0]) + 0.7152f * plane(lobe.value[1]) + 0.0722f * plane(lobe.value[2]);
        m_power = (m_luminance * m_root_area).square().sum();
    }

    float run(int steps, std::vector<GaussianTap>& taps);
    float residual(const std::vector<GaussianTap>& taps) const;

private:
    struct State {
        MatrixXf basis;  // rows: quadrature points times root area, then energy, then ridge
        VectorXf weights, residual;
        float cost;
    };

    Index points() const { return m_x.size(); }
    ArrayXf along(const Vec3f& v) const { return m_x * v.x + m_y * v.y + m_z * v.z; }
    /// 1 - wi . d, without the loss of digits that the cosine has for lobes as narrow as a mirror's.
    ArrayXf versine(const Vec3f& d) const {
        return 0.5f * ((m_x - d.x).square() + (m_y - d.y).square() + (m_z - d.z).square());
    }
    State evaluate(const std::vector<GaussianTap>& taps) const;
    VectorXf target(const ArrayXf& value, float albedo, Index taps) const;
    MatrixXf jacobian(const std::vector<GaussianTap>& taps, const State& state) const;
    std::vector<GaussianTap> moved(const std::vector<GaussianTap>& taps, const VectorXf& step) const;
    void set_weights(const State& state, std::vector<GaussianTap>& taps) const;

    const LobeQuadrature& m_lobe;
    Vec3f m_wo;
    int m_unknowns;  // per tap
    Plane m_x, m_y, m_z, m_root_area;
    ArrayXf m_luminance;
    float m_albedo, m_power;
};

VectorXf solve(const MatrixXf& basis, const VectorXf& target) {
    const Eigen::MatrixXd normal = (basis.transpose() * basis).cast<double>();
    return normal.ldlt().solve((basis.transpose() * target).cast<double>()).cast<float>();
}

Fit::State Fit::evaluate(const std::vector<GaussianTap>& taps) const {
    const auto n = static_cast<Index>(taps.size()), rows = points();
    State state;
    state.basis = MatrixXf::Zero(rows + 1 + n, n);
    for (Index i = 0; i < n; ++i) {
        const GaussianTap& tap = taps[static_cast<size_t>(i)];
        const Vec3f d = tap_direction(m_wo, tap.sx, tap.sy);
        const float k = 1 / (std::exp(2 * tap.log_sigma) + m_lobe.blur * m_lobe.blur),
                    norm = k / (2 * kPi * (1 - std::exp(-2 * k)));
        state.basis.col(i).head(rows) = (-k * versine(d)).exp() * m_root_area * norm;
    }
    const float unit = std::sqrt(m_power) / m_albedo;
    state.basis.row(rows).setConstant(std::sqrt(kEnergy) * unit);
    state.basis.bottomRows(n).diagonal().setConstant(std::sqrt(kRidge * static_cast<float>(n)) * unit);
    const VectorXf wanted = target(m_luminance, m_albedo, n);
    state.weights = solve(state.basis, wanted);
    state.residual = state.basis * state.weights - wanted;
    state.cost = state.residual.squaredNorm() / m_power;
    return state;
}

VectorXf Fit::target(const ArrayXf& value, float albedo, Index taps) const {
    VectorXf wanted = VectorXf::Zero(points() + 1 + taps);
    wanted.head(points()) = (value * m_root_area).matrix();
    wanted[points()] = std::sqrt(kEnergy * m_power) * albedo / m_albedo;
    return wanted;
}

/// Change of the residual with the unknowns (sx of all taps, log sigma of all, sy of all), beyond what new weights can make good.
MatrixXf Fit::jacobian(const std::vector<GaussianTap>& taps, const State& state) const {
    const Index n = state.weights.size(), rows = points();
    MatrixXf change = MatrixXf::Zero(state.basis.rows(), n * m_unknowns);
    for (Index i = 0; i < n; ++i) {
        const GaussianTap& tap = taps[static_cast<size_t>(i)];
        const Vec3f d = tap_direction(m_wo, tap.sx, tap.sy);
        const DirectionSlopes slopes = direction_slopes(m_wo, tap.sx, tap.sy);
        const float variance = std::exp(2 * tap.log_sigma), k = 1 / (variance + m_lobe.blur * m_lobe.blur);
        const ArrayXf gaussian = state.basis.col(i).head(rows).array() * state.weights[i];
        const auto turned = [&](const Vec3f& slope) -> ArrayXf { return gaussian * k * (along(slope) - d.dot(slope)); };
        change.col(i).head(rows) = turned(slopes.x);
        change.col(n + i).head(rows) = gaussian * (2 * k * versine(d) - 2) * (k * variance);
        if (m_unknowns == 3) change.col(2 * n + i).head(rows) = turned(slopes.y);
    }
    const Eigen::MatrixXd normal = (state.basis.transpose() * state.basis).cast<double>();
    const MatrixXf part = normal.ldlt().solve((state.basis.transpose() * change).cast<double>()).cast<float>();
    return change - state.basis * part;
}

/// A step of at most the Gaussian's own width, so that no tap leaps over its neighbour.
std::vector<GaussianTap> Fit::moved(const std::vector<GaussianTap>& taps, const VectorXf& step) const {
    std::vector<GaussianTap> result = taps;
    const auto n = static_cast<Index>(taps.size());
    for (Index i = 0; i < n; ++i) {
        GaussianTap& tap = result[static_cast<size_t>(i)];
        const float reach = std::exp(tap.log_sigma);
        tap.sx += std::clamp(step[i], -reach, reach);
        tap.log_sigma += std::clamp(step[n + i], -0.5f, 0.5f);
        tap.log_sigma = std::clamp(tap.log_sigma, std::log(m_lobe.finest), std::log(kWidest));
        if (m_unknowns == 3) tap.sy += std::clamp(step[2 * n + i], -reach, reach);
        const float slope = std::hypot(tap.sx, tap.sy);
        if (slope > m_lobe.farthest) tap.sx *= m_lobe.farthest / slope, tap.sy *= m_lobe.farthest / slope;
    }
    return result;
}

void Fit::set_weights(const State& state, std::vector<GaussianTap>& taps) const {
    const auto n = static_cast<Index>(taps.size());
    for (int channel = 0; channel < 3; ++channel) {
        const VectorXf weights =
            solve(state.basis, target(plane(m_lobe.value[static_cast<size_t>(channel)]), m_lobe.albedo[channel], n));
        for (Index i = 0; i < n; ++i) taps[static_cast<size_t>(i)].weight[channel] = weights[i];
    }
}

float Fit::run(int steps, std::vector<GaussianTap>& taps) {
    State state = evaluate(taps);
    float damping = 1e-2f;
    for (int step = 0; step < steps; ++step) {
        const MatrixXf J = jacobian(taps, state);
        const MatrixXf JtJ = J.transpose() * J;
        const VectorXf gradient = J.transpose() * state.residual;
        const float before = state.cost;
        for (int attempt = 0; attempt < 5; ++attempt, damping *= 5) {
            MatrixXf damped = JtJ;
            damped.diagonal() += damping * JtJ.diagonal();
            damped.diagonal().array() += 1e-7f * m_power;
            std::vector<GaussianTap> there = moved(taps, -damped.ldlt().solve(gradient));
            State next = evaluate(there);
            if (next.cost >= state.cost) continue;
            taps = std::move(there), state = std::move(next), damping = std::max(damping * 0.2f, 1e-6f);
            break;
        }
        if (before - state.cost < kEnough * before) break;
    }
    set_weights(state, taps);
    return state.residual.head(points()).norm() / std::sqrt(m_power);
}

float Fit::residual(const std::vector<GaussianTap>& taps) const {
    const State state = evaluate(taps);
    VectorXf weights(state.weights.size());
    for (Index i = 0; i < weights.size(); ++i) weights[i] = luminance(taps[static_cast<size_t>(i)].weight);
    const VectorXf error = state.residual + state.basis * (weights - state.weights);
    return error.head(points()).norm() / std::sqrt(m_power);
}

}  // namespace

Vec3f tap_direction(const Vec3f& wo, float sx, float sy) {
    return reflect(wo, Vec3f(sx, sy, 1) / std::sqrt(1 + sx * sx + sy * sy));
}

float fit_gaussians(const LobeQuadrature& lobe, const Vec3f& wo, bool in_plane, int steps, std::vector<GaussianTap>& taps) {
    return Fit(lobe, wo, in_plane).run(steps, taps);
}

float residual_of(const LobeQuadrature& lobe, const Vec3f& wo, const std::vector<GaussianTap>& taps) {
    return Fit(lobe, wo, false).residual(taps);
}

}  // namespace burnish
