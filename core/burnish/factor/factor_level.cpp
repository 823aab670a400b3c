#include <burnish/factor/factor_level.h>

namespace burnish {
namespace {

Factors laid_out(const Parametrization& parametrization, const FactorGuide& guide, const FactoriseSettings& settings,
                 int terms) {
    Factors factors = uniform_factors(parametrization, settings.sphere, settings.size);
    factors.guide = guide;
    factors.terms.resize(terms, factors.terms[0]);
    return factors;
}

ColorRow mean_value(std::span<const FactorSample> samples) {
    Eigen::Array<double, 1, 4> sum = Eigen::Array<double, 1, 4>::Zero();
    for (const FactorSample& s : samples) sum += Eigen::Array<double, 1, 4>(s.value.x, s.value.y, s.value.z, 0);
    return (sum / static_cast<double>(samples.size())).cast<float>();
}

}  // namespace

FactorLevel::FactorLevel(const Parametrization& parametrization, std::span<const FactorSample> all, const FactorGuide& guide,
                         const FactoriseSettings& settings, int terms)
    : factors(laid_out(parametrization, guide, settings, terms)),
      samples(all),
      lookups(factors, samples),
      mean(mean_value(samples)),
      unknowns{mean.pow(1.0f / static_cast<float>(parametrization.factors.size())), lookups.texels() / terms},
      R(map_smoothness(factors, settings.smoothness)) {}

}  // namespace burnish
