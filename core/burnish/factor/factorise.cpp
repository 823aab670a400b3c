#include <burnish/factor/factorise.h>

#include <burnish/factor/averaged_start.h>
#include <burnish/factor/blend_system.h>
#include <burnish/factor/map_smoothness.h>

namespace burnish {
namespace {

constexpr int kCoarsest = 16;  // texels a side, where the first solution is found

void check(std::span<const FactorSample> samples) {
    if (samples.empty()) throw Error(ErrorCode::bad_argument, "there are no samples to factor; expected at least one");
    for (size_t i = 0; i < samples.size(); ++i) {
        const FactorSample& s = samples[i];
        const float least = std::min({s.value.x, s.value.y, s.value.z, s.weight});
        if (is_finite(s.pair.a) && is_finite(s.pair.b) && is_finite(s.value) && std::isfinite(s.weight) && least >= 0) continue;
        throw Error(ErrorCode::bad_argument,
                    "sample " + std::to_string(i) +
                        " to factor is not finite or below zero; expected finite directions and values "
                        "and weights of at least 0");
    }
}

ColorRow mean_value(std::span<const FactorSample> samples) {
    Eigen::Array<double, 1, 4> sum = Eigen::Array<double, 1, 4>::Zero();
    for (const FactorSample& s : samples) sum += Eigen::Array<double, 1, 4>(s.value.x, s.value.y, s.value.z, 0);
    return (sum / static_cast<double>(samples.size())).cast<float>();
}

/// Factor 26; 0 in channels that are zero everywhere.
Colors logarithms(std::span<const FactorSample> samples, const ColorRow& mean, float bias) {
    Colors logs(static_cast<Eigen::Index>(samples.size()), 4);
    for (Eigen::Index s = 0; s < logs.rows(); ++s) {
        const Color3f& f = samples[s].value;
        const ColorRow scaled = ColorRow(f.x, f.y, f.z, 0) / mean;
        logs.row(s) = (mean > 0).select((scaled + bias).log(), 0.0f);
    }
    return logs;
}

/// Texels of one term to and from the rows of a matrix, each map's scaled by its share of the mean.
void from_logarithms(FactorTerm& term, const Colors& x, const ColorRow& share) {
    Eigen::Index row = 0;
    for (FactorMap& map : term)
        for (Color3f& texel : map.texels) {
            const ColorRow t = share * x.row(row++).array().exp();
            texel = {t[0], t[1], t[2]};
        }
}

Colors to_logarithms(const FactorTerm& term, const FactorTerm& coarse, const ColorRow& share, int texels) {
    Colors x(texels, 4);
    Eigen::Index row = 0;
    for (size_t map = 0; map < term.size(); ++map)
        for (int texel = 0; texel < term[map].layout.texels(); ++texel) {
            const Color3f t = coarse[map].lookup(term[map].layout.direction(texel));
            x.row(row++) = (share > 0).select((ColorRow(t.x, t.y, t.z, 0) / share).log(), 0.0f);
        }
    return x;
}

/// Every 4^level-th sample, at distances that keep out of step with grids.
std::vector<FactorSample> thinned(std::span<const FactorSample> samples) {
    constexpr double kGolden = 0.6180339887498949;
    std::vector<FactorSample> some;
    for (size_t i = 0; i < samples.size(); ++i) {
        const double at = static_cast<double>(i) * kGolden;
        if (at - std::floor(at) < 0.25) some.push_back(samples[i]);
    }
    return some;
}

Factors solved(const Parametrization& parametrization, std::span<const FactorSample> samples, const FactorGuide& guide,
               const FactoriseSettings& settings, const Progress& progress) {
    Factors factors = uniform_factors(parametrization, settings.sphere, settings.size);
    factors.guide = guide;
    const SampleLookups lookups(factors, samples);
    const ColorRow mean = mean_value(samples), share = mean.pow(1.0f / static_cast<float>(lookups.factors()));
    const Eigen::SparseMatrix<float, Eigen::RowMajor> R = map_smoothness(factors, settings.smoothness);
    const Colors logs = logarithms(samples, mean, settings.bias);
    Colors x;
    if (settings.size >= 2 * kCoarsest) {
        FactoriseSettings half = settings;
        half.size = settings.size / 2;
        const Factors coarse = solved(parametrization, thinned(samples), guide, half, part_of(progress, 0, 0.3f));
        x = to_logarithms(factors.terms[0], coarse.terms[0], share, lookups.texels());
    } else {
        x = averaged_start(factors, lookups, logs);
    }
    progress.report("factor", 0.3f);
    BlendSystem system{lookups, R, Colors(logs.rows() * lookups.factors(), 4), logs, Colors::Ones(lookups.texels(), 4), 1};
    for (Eigen::Index s = 0; s < logs.rows(); ++s) {
        const float weight = std::sqrt(samples[s].weight);
        system.b.row(s) *= weight;
        system.c.middleRows(s * lookups.factors(), lookups.factors()).setConstant(weight);
    }
    x = solve(system, std::move(x), {settings.iterations, settings.tolerance});
    from_logarithms(factors.terms[0], x, share);
    progress.report("factor", 1);
    return factors;
}

}  // namespace

Factors factorise(const Parametrization& parametrization, std::span<const FactorSample> samples, const FactorGuide& guide,
                  const FactoriseSettings& settings, const Progress& progress) {
    check(samples);
    return solved(parametrization, samples, guide, settings, progress);
}

}  // namespace burnish
