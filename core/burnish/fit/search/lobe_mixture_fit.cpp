#include <burnish/fit/search/diffuse_mode.h>
#include <burnish/fit/search/l1_polish.h>
#include <burnish/fit/search/lobe_mixture_fit.h>
#include <burnish/fit/search/lobe_search.h>
#include <burnish/fit/search/table_noise.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr size_t kSearched = 4096, kPolished = 16384;  // samples that stand for all while lobes are looked for
constexpr int kValleys = 3;                            // starts of each new lobe
constexpr double kMissed = 0.01;                       // share of the samples
constexpr double kRounding = 1e-5;                     // errors below this share of the light are those of floats

bool all_borne_out(const LobeMixture& mixture, const TransferSamples& samples) {
    const std::vector<float> measured = grey(samples.p);
    for (size_t n = 0; n < mixture.lobes.size(); ++n) {
        LobeMixture alone = mixture;
        alone.kd = 0;
        alone.lobes = {mixture.lobes[n]};
        if (!is_borne_out(mixture_transfer(alone, samples), measured, mixture.spaces[n].parameters())) return false;
    }
    return true;
}

class Growth {
public:
    Growth(const TransferSamples& samples, Side side, ModelId model, bool round, const FitSettings& settings)
        : m_all(samples),
          m_polished(thinned(samples, kPolished)),
          m_searched(thinned(samples, kSearched)),
          m_side(side),
          m_model(model),
          m_round(round),
          m_bounds(settings.bounds) {}

    LobeMixture without_lobes() const {
        LobeMixture mixture;
        mixture.side = m_side;
        if (m_side == Side::reflection) {
            if (const NumberRange* range = find_bounds(m_bounds, 1, "kd")) mixture.kd_range = *range;
            const Color3f kd = diffuse_mode(m_all);
            mixture.kd =
                static_cast<float>(std::clamp<double>((kd.x + kd.y + kd.z) / 3, mixture.kd_range.min, mixture.kd_range.max));
        }
        mixture.error = mixture_error(mixture, m_all, grey(m_all.p));
        return mixture;
    }

    /// `mixture` and one more lobe.
    LobeMixture with_another(const LobeMixture& mixture, const Progress& progress) const {
        LobeMixture best;
        const LobeSpace space = lobe_space(m_model, m_side, static_cast<int>(mixture.lobes.size()) + 1, m_round, m_bounds);
        for (const FoundLobe& found :
             search_lobe(space, m_searched, left_over(mixture, m_searched), kValleys, part_of(progress, 0, kSearch))) {
            LobeMixture next = mixture;
            next.lobes.push_back(found.lobe);
            next.spaces.push_back(space);
            next = polished(std::move(next), m_polished, grey(m_polished.p), at(progress, kSearch));
            if (best.lobes.empty() || better(next, best)) best = std::move(next);
        }
        if (best.lobes.empty()) return mixture;  // nothing that the table bears out
        if (best.lobes.size() > 1) best = alternated(std::move(best), at(progress, kAlternation));
        return polished(std::move(best), m_all, grey(m_all.p), part_of(progress, kAlternation, 1));
    }

private:
    static constexpr float kSearch = 0.4f, kAlternation = 0.8f;  // of the time for a lobe, done when that is

    /// Stands still there, as nobody knows how often this work comes.
    static Progress at(const Progress& progress, float done) { return part_of(progress, done, done); }

    /// Each lobe searched for anew in what the others leave, if that leads lower.
    LobeMixture alternated(LobeMixture best, const Progress& progress) const {
        for (size_t n = 0; n < best.lobes.size(); ++n) {
            LobeMixture others = best;
            others.lobes[n].strength = 0;
            for (const FoundLobe& found :
                 search_lobe(best.spaces[n], m_searched, left_over(others, m_searched), kValleys, progress)) {
                LobeMixture next = others;
                next.lobes[n] = found.lobe;
                next = polished(std::move(next), m_polished, grey(m_polished.p), progress);
                if (better(next, best)) best = std::move(next);
            }
        }
        return best;
    }

    /// Of less error, among mixtures that the table bears out.
    bool better(const LobeMixture& one, const LobeMixture& other) const {
        const bool borne = all_borne_out(one, m_all), other_borne = all_borne_out(other, m_all);
        return borne != other_borne ? borne : one.error < other.error;
    }

    /// What the mixture leaves of p; not below 0, else a lobe that fills a gap would cost more than it gains elsewhere.
    static std::vector<float> left_over(const LobeMixture& mixture, const TransferSamples& samples) {
        std::vector<float> left = grey(samples.p);
        const std::vector<float> model = mixture_transfer(mixture, samples);
        for (size_t j = 0; j < left.size(); ++j) left[j] = std::max(0.0f, left[j] - model[j]);
        return left;
    }

    const TransferSamples& m_all;
    const TransferSamples m_polished, m_searched;
    const Side m_side;
    const ModelId m_model;
    const bool m_round;
    const ParameterBounds& m_bounds;
};

/// As many samples of equal weight as these are worth.
double effective_count(const TransferSamples& samples) {
    double squares = 0;
    for (const float w : samples.weight) squares += static_cast<double>(w) * w;
    return squares > 0 ? 1 / squares : 0;
}

/// Mean p, which errors are shares of.
double light(const TransferSamples& samples) {
    const std::vector<float> p = grey(samples.p);
    double sum = 0;
    for (size_t j = 0; j < p.size(); ++j) sum += static_cast<double>(samples.weight[j]) * p[j];
    return sum;
}

/// Each sample's share of the error.
std::vector<double> errors_of(const LobeMixture& mixture, const TransferSamples& samples) {
    const std::vector<float> measured = grey(samples.p), model = mixture_transfer(mixture, samples);
    std::vector<double> errors(measured.size());
    for (size_t j = 0; j < errors.size(); ++j) errors[j] = samples.weight[j] * std::abs(measured[j] - model[j]);
    return errors;
}

/// By what share the error falls from `fewer` to `more`, over samples where `fewer` errs by `limit` at most.
double gain(const std::vector<double>& fewer, const std::vector<double>& more, double limit) {
    double before = 0, after = 0;
    for (size_t j = 0; j < fewer.size(); ++j)
        if (fewer[j] <= limit) before += fewer[j], after += more[j];
    return before > 0 ? 1 - after / before : 0;
}

bool pays(const LobeMixture& fewer, const LobeMixture& more, const TransferSamples& samples) {
    const std::vector<double> before = errors_of(fewer, samples), after = errors_of(more, samples);
    std::vector<double> sorted = before;
    const auto most = sorted.end() - 1 - static_cast<std::ptrdiff_t>(kMissed * static_cast<double>(sorted.size()));
    std::ranges::nth_element(sorted, most);
    const double count = effective_count(samples),
                 of_noise = 0.5 * std::log(count) / count;  // Schwarz' rule for Laplace's errors
    const int added = more.parameters() - fewer.parameters();
    return std::max(gain(before, after, *std::ranges::max_element(before)), gain(before, after, *most)) >
           added * std::max(kGainPerNumber, of_noise);
}

/// The largest number of lobes that pays over the last one that did.
size_t needed_lobes(const std::vector<LobeMixture>& by_lobes, const TransferSamples& samples) {
    size_t chosen = 0;
    for (size_t k = 1; k < by_lobes.size(); ++k)
        if (pays(by_lobes[chosen], by_lobes[k], samples) && all_borne_out(by_lobes[k], samples)) chosen = k;
    return chosen;
}

/// Whether bounds speak of one lobe, whose number then has to stay.
bool numbered(const ParameterBounds& bounds) {
    return std::ranges::any_of(bounds, [](const auto& entry) { return entry.first.find('.') != std::string::npos; });
}

/// The strongest first.
void sort_lobes(LobeMixture& mixture) {
    const auto facing = [](const LobeParameters& lobe) {
        const bool schlick = lobe.fresnel.kind == FresnelKind::schlick;
        return lobe.strength * (schlick && lobe.side == Side::reflection ? lobe.fresnel.eta.x : 1);
    };
    std::ranges::stable_sort(mixture.lobes, std::greater{}, facing);
}

}  // namespace

SideFit fit_side(const TransferSamples& samples, Side side, ModelId model, bool round, const FitSettings& settings,
                 const Progress& progress) {
    const Growth growth(samples, side, model, round, settings);
    SideFit fit;
    fit.by_lobes.push_back(growth.without_lobes());
    const double enough = kRounding * light(samples);
    for (int k = 1; k <= settings.max_lobes; ++k) {
        if (fit.by_lobes.back().error <= enough && !settings.fixed_lobes) break;
        const auto most = static_cast<float>(settings.max_lobes), done = static_cast<float>(k - 1);
        fit.by_lobes.push_back(growth.with_another(fit.by_lobes.back(), part_of(progress, done / most, (done + 1) / most)));
    }
    fit.chosen = settings.fixed_lobes ? fit.by_lobes.size() - 1 : needed_lobes(fit.by_lobes, samples);
    if (!numbered(settings.bounds)) sort_lobes(fit.by_lobes[fit.chosen]);
    fit.noise = noise_level(samples, mixture_transfer(fit.by_lobes.back(), samples));
    return fit;
}

}  // namespace burnish
