#include <burnish/factor/log_solution.h>

#include <burnish/factor/averaged_start.h>
#include <burnish/factor/blend_system.h>

namespace burnish {
namespace {

constexpr int kCoarsest = 16;  // texels a side, where the first solution is found

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

/// A quarter of the samples, at distances that keep out of step with grids.
std::vector<FactorSample> thinned(std::span<const FactorSample> samples) {
    constexpr double kGolden = 0.6180339887498949;
    std::vector<FactorSample> some;
    for (size_t i = 0; i < samples.size(); ++i) {
        const double at = static_cast<double>(i) * kGolden;
        if (at - std::floor(at) < 0.25) some.push_back(samples[i]);
    }
    return some;
}

Colors least_squares(const FactorLevel& level, const Colors& logs, Colors x, const SolveLimits& limits) {
    const int factors = level.lookups.factors();
    BlendSystem system{level.lookups, level.R, Colors(logs.rows() * factors, 4), logs, Colors::Ones(level.lookups.texels(), 4)};
    for (Eigen::Index s = 0; s < logs.rows(); ++s) {
        const float weight = std::sqrt(level.samples[s].weight);
        system.b.row(s) *= weight;
        system.c.middleRows(s * factors, factors).setConstant(weight);
    }
    return solve(system, std::move(x), limits);
}

/// The solution of half the size.
Colors coarse_start(const FactorLevel& level, const FactoriseSettings& settings) {
    FactoriseSettings half = settings;
    half.size = settings.size / 2;
    const std::vector<FactorSample> some = thinned(level.samples);
    FactorLevel coarse(*level.factors.parametrization, some, level.factors.guide, half);
    coarse.set_texels(log_solution(coarse, half));
    return level.unknowns.looked_up(level.factors, coarse.factors);
}

}  // namespace

Colors log_solution(const FactorLevel& level, const FactoriseSettings& settings) {
    const Colors logs = logarithms(level.samples, level.mean, settings.bias);
    const bool is_coarsest = settings.size < 2 * kCoarsest;
    Colors start = is_coarsest ? averaged_start(level.factors, level.lookups, logs) : coarse_start(level, settings);
    return least_squares(level, logs, std::move(start), {settings.iterations, settings.tolerance});
}

}  // namespace burnish
