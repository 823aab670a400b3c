#include <burnish/factor/factorise.h>

#include <burnish/factor/log_solution.h>
#include <burnish/factor/polish.h>
#include <burnish/factor/tell_by_views.h>

namespace burnish {
namespace {

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

void check(const FactoriseSettings& settings) {
    constexpr int kMostTerms = 8;
    if (settings.terms < 0 || settings.terms > kMostTerms)
        throw Error(ErrorCode::bad_argument, "expected up to 8 terms of a factorisation (0: by its parametrisation), found " +
                                                 std::to_string(settings.terms));
    if (settings.terms > 1 && !settings.polish)
        throw Error(ErrorCode::bad_argument,
                    "a factorisation of more than one term needs its polish; leave it on, or ask for one term");
}

/// Half a turn more for each `order`, along a direction that no mapping favours.
float wave(const Vec3f& d, int order) {
    return std::cos(kPi * static_cast<float>(order) * 0.5f * (1 + d.dot(Vec3f(0.48f, 0.6f, 0.64f))));
}

/// The largest of the maps that are read once a sample: the fit begins with it.
int leading_map(const Factors& factors) {
    const FactorTerm& term = factors.terms[0];
    int leading = -1;
    for (int map = 0; map < static_cast<int>(term.size()); ++map)
        if (factors.parametrization->uses(map) == 1 &&
            (leading < 0 || term[map].layout.texels() > term[leading].layout.texels()))
            leading = map;
    return leading;
}

/// Appends a term that is 0, as its leading map is, and whose other maps go up and down, for each new term once more: so that any
/// residual tells on it.
Colors with_new_term(const Factors& factors, const Colors& x) {
    const FactorTerm& term = factors.terms[0];
    const int leading = leading_map(factors), order = static_cast<int>(factors.terms.size()) - 1;
    int count = 0;
    for (const FactorMap& map : term) count += map.layout.texels();
    Colors grown = Colors::Zero(x.rows() + count, 4);
    grown.topRows(x.rows()) = x;
    Eigen::Index row = x.rows();
    for (int map = 0; map < static_cast<int>(term.size()); ++map)
        for (int texel = 0; texel < term[map].layout.texels(); ++texel, ++row)
            if (map != leading) grown.row(row).setConstant(wave(term[map].layout.direction(texel), order));
    return grown;
}

Colors polished(const FactorLevel& level, Colors x, const FactoriseSettings& settings, const Progress& progress) {
    const MeasuredResidual measure(settings.measure, level.mean, settings.bias);
    return Polish{level.samples, level.lookups, level.unknowns, level.R, measure}(std::move(x), progress);
}

}  // namespace

Factors factorise(const Parametrization& parametrization, std::span<const FactorSample> samples, const FactorGuide& guide,
                  const FactoriseSettings& settings, const Progress& progress) {
    check(samples);
    check(settings);
    progress.report("factor", 0);
    const int all_terms = !settings.polish ? 1 : settings.terms > 0 ? settings.terms : parametrization.terms;
    const float share = 1 / static_cast<float>(all_terms);
    FactorLevel level(parametrization, samples, guide, settings);
    Colors x = log_solution(level, settings);
    if (settings.polish) x = polished(level, std::move(x), settings, part_of(progress, 0.2f * share, share));
    level.set_texels(x);
    for (int terms = 2; terms <= all_terms; ++terms) {
        const float done = share * static_cast<float>(terms);
        level = FactorLevel(parametrization, samples, guide, settings, terms);
        x = polished(level, with_new_term(level.factors, x), settings, part_of(progress, done - share, done));
        level.set_texels(x);
    }
    tell_by_views(level.factors);
    progress.report("factor", 1);
    return level.factors;
}

}  // namespace burnish
