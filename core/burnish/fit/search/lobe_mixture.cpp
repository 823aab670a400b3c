#include <burnish/fit/search/lobe_basis.h>
#include <burnish/fit/search/lobe_mixture.h>

#include <cmath>
#include <numeric>

namespace burnish {
namespace {

constexpr double kDifference = 2e-4;  // of a parameter's range, for derivatives by the shape

/// The slopes of one batch of samples.
class Batch {
public:
    Batch(const LobeMixture& mixture, const TransferSamples& samples, size_t begin, size_t end)
        : m_mixture(mixture), m_samples(samples), m_begin(begin), m_end(end) {
        for (size_t n = 0; n < mixture.lobes.size(); ++n) m_lobes.push_back(lobe(mixture.lobes[n], n));
    }

    Eigen::VectorXd model() const {
        Eigen::VectorXd sum = m_mixture.kd / kPi * cosines();
        if (m_mixture.side == Side::transmission) sum.setZero();
        for (const Eigen::VectorXd& values : m_lobes) sum += values;
        return sum;
    }

    Eigen::VectorXd slope(const Unknown& unknown) const {
        const double range = unknown.range.max - unknown.range.min;
        const size_t n = unknown.lobe;
        switch (unknown.kind) {
            case Unknown::Kind::kd: return range / kPi * cosines();
            case Unknown::Kind::strength: return range * by_strength(n);
            case Unknown::Kind::r0: return at_r0(n, unknown.range.max) - at_r0(n, unknown.range.min);
            case Unknown::Kind::shape: break;
        }
        const double at = unknown.get(m_mixture), change = at > 0.5 ? -kDifference : kDifference;
        LobeMixture moved = m_mixture;
        unknown.set(moved, at + change);
        return (lobe(moved.lobes[n], n) - m_lobes[n]) / change;
    }

private:
    int rows() const { return static_cast<int>(m_end - m_begin); }
    Eigen::VectorXd cosines() const {
        return Eigen::Map<const Eigen::VectorXf>(&m_samples.cosine[m_begin], rows()).cast<double>();
    }

    /// p of a lobe with its own strength and r0.
    Eigen::VectorXd lobe(const LobeParameters& parameters, size_t n) const {
        thread_local LobeBasis basis;
        const double r0 = m_mixture.spaces[n].has_fresnel ? parameters.fresnel.eta.x : 0;
        lobe_basis(parameters, {r0, r0}, m_samples, m_begin, m_end, basis);
        return parameters.strength * Eigen::Map<const Eigen::VectorXf>(basis.low.data(), rows()).cast<double>();
    }

    Eigen::VectorXd by_strength(size_t n) const {
        LobeParameters unit = m_mixture.lobes[n];
        if (unit.strength > 0) return m_lobes[n] / unit.strength;
        unit.strength = 1;
        return lobe(unit, n);
    }

    Eigen::VectorXd at_r0(size_t n, double r0) const {
        LobeParameters parameters = m_mixture.lobes[n];
        parameters.fresnel.eta = Color3f(static_cast<float>(r0));
        return lobe(parameters, n);
    }

    const LobeMixture& m_mixture;
    const TransferSamples& m_samples;
    const size_t m_begin, m_end;
    std::vector<Eigen::VectorXd> m_lobes;
};

}  // namespace

int LobeMixture::parameters() const { return static_cast<int>(unknowns(*this).size()); }

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

double Unknown::get(const LobeMixture& mixture) const {
    const auto unit = [&](double value) { return (value - range.min) / (range.max - range.min); };
    switch (kind) {
        case Kind::kd: return unit(mixture.kd);
        case Kind::strength: return unit(mixture.lobes[lobe].strength);
        case Kind::r0: return unit(mixture.lobes[lobe].fresnel.eta.x);
        case Kind::shape: break;
    }
    const ShapeParameter& parameter = mixture.spaces[lobe].shape[shape];
    return parameter.unit(parameter.get(mixture.lobes[lobe]));
}

void Unknown::set(LobeMixture& mixture, double unit) const {
    const float value = static_cast<float>(range.min + unit * (range.max - range.min));
    switch (kind) {
        case Kind::kd: mixture.kd = value; break;
        case Kind::strength: mixture.lobes[lobe].strength = value; break;
        case Kind::r0: mixture.lobes[lobe].fresnel.eta = Color3f(value); break;
        case Kind::shape:
            const ShapeParameter& parameter = mixture.spaces[lobe].shape[shape];
            parameter.set(mixture.lobes[lobe], parameter.at(unit));
            settle_width(mixture.lobes[lobe]);
            break;
    }
}

std::string Unknown::name(const LobeMixture& mixture) const {
    switch (kind) {
        case Kind::kd: return "kd";
        case Kind::strength: return mixture.side == Side::reflection ? "ks" : "kt";
        case Kind::r0: return "r0";
        case Kind::shape: break;
    }
    return mixture.spaces[lobe].shape[shape].name;
}

std::vector<Unknown> unknowns(const LobeMixture& mixture) {
    using Kind = Unknown::Kind;
    std::vector<Unknown> list;
    const auto add = [&](const Unknown& unknown) {
        if (unknown.range.max > unknown.range.min) list.push_back(unknown);
    };
    if (mixture.side == Side::reflection) add({Kind::kd, 0, 0, mixture.kd_range});
    for (size_t n = 0; n < mixture.spaces.size(); ++n) {
        const LobeSpace& space = mixture.spaces[n];
        add({Kind::strength, n, 0, space.strength});
        if (space.has_fresnel) add({Kind::r0, n, 0, space.r0});
        for (size_t i = 0; i < space.shape.size(); ++i) add({Kind::shape, n, i, space.shape[i].range});
    }
    return list;
}

MixtureSlopes mixture_slopes(const LobeMixture& mixture, const std::vector<Unknown>& unknowns, const TransferSamples& samples,
                             size_t begin, size_t end) {
    const Batch batch(mixture, samples, begin, end);
    MixtureSlopes result{batch.model(), Eigen::MatrixXd(end - begin, unknowns.size())};
    for (size_t u = 0; u < unknowns.size(); ++u) result.slope.col(static_cast<int>(u)) = batch.slope(unknowns[u]);
    return result;
}

}  // namespace burnish
