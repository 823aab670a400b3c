#include <burnish/factor/brdf_samples.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/factor/pair_grid.h>

namespace burnish {
namespace {

Vec3f turned(const Vec3f& d, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {c * d.x - s * d.y, s * d.x + c * d.y, d.z};
}

}  // namespace

std::vector<FactorSample> brdf_samples(const Parametrization& parametrization, const PairFunction& f,
                                       const BrdfSampling& sampling) {
    const PairGrid grid(parametrization, sampling.size);
    std::vector<std::vector<FactorSample>> rows(grid.directions().size());
    for_each_index(static_cast<int>(rows.size()), [&](int row) {
        for (const Vec3f& second : grid.directions()) {
            const DirectionPair pair = parametrization.pair_of(grid.directions()[row], second);
            if (std::min(pair.a.z, pair.b.z) >= sampling.least_cosine) rows[row].push_back({pair, f(pair), 1});
        }
    });
    std::vector<FactorSample> samples;
    for (const auto& row : rows) samples.insert(samples.end(), row.begin(), row.end());
    return samples;
}

std::vector<FactorSample> measured_samples(const MeasuredBrdf& brdf, int turns) {
    constexpr float kGolden = 0.618034f;
    if (!brdf.is_isotropic()) turns = 1;
    std::vector<FactorSample> samples;
    float offset = 0;  // of a turn: another one for each pair, so that they fill the circle
    for (const BrdfSample& measured : brdf.samples()) {
        if (measured.wi.z <= 0) continue;
        for (int turn = 0; turn < turns; ++turn) {
            const float angle =
                brdf.is_isotropic() ? 2 * kPi * (static_cast<float>(turn) + offset) / static_cast<float>(turns) : 0;
            samples.push_back({{turned(measured.wi, angle), turned(measured.wo, angle)}, measured.f, 1});
        }
        offset = std::fmod(offset + kGolden, 1.0f);
    }
    return samples;
}

}  // namespace burnish
