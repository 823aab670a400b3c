#include <burnish/factor/prescale_search.h>

#include <burnish/base/error.h>
#include <burnish/factor/factor_error.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kBias = 1e-5f;  // of the mean: what is darker does not count

/// Samples enough to tell choices apart, from all over the list.
std::vector<FactorSample> some_of(std::span<const FactorSample> samples) {
    constexpr size_t kEnough = 6000;
    if (samples.size() <= kEnough) return {samples.begin(), samples.end()};
    std::vector<FactorSample> some;
    for (size_t i = 0; i < kEnough; ++i) {
        const double place = static_cast<double>(i) * std::numbers::phi;
        some.push_back(samples[static_cast<size_t>((place - std::floor(place)) * static_cast<double>(samples.size()))]);
    }
    return some;
}

/// Goes to the best place along one axis after the other.
class Search {
public:
    Search(const Factors& factors, const QuantiseSettings& start, std::vector<FactorSample> samples)
        : m_factors(factors), m_samples(std::move(samples)), m_best(start) {
        m_least = error(start);
    }

    double least() const { return m_least; }
    const QuantiseSettings& best() const { return m_best; }

    void try_weights() {
        constexpr int kStops = 21;
        for (size_t map = 1; map < m_best.weights.size(); ++map)
            for (int step = 0; step < kStops; ++step) {
                QuantiseSettings settings = m_best;
                const float weight = std::ldexp(1.0f, step);
                settings.weights[0] /= std::pow(weight / settings.weights[map], uses(map));
                settings.weights[map] = weight;
                take_if_better(settings);
            }
    }

    void try_scales() {
        for (const float scale : {1.0f, 2.0f, 4.0f, 8.0f, 16.0f}) {
            QuantiseSettings settings = m_best;
            settings.scale = scale;
            take_if_better(settings);
        }
    }

private:
    float uses(size_t map) const { return static_cast<float>(m_factors.parametrization->uses(static_cast<int>(map) - 1)); }

    double error(const QuantiseSettings& settings) const {
        const FactorError told = factor_error(quantise(m_factors, settings), m_samples, kBias);
        return told.average_relative * told.rms;
    }

    void take_if_better(const QuantiseSettings& settings) {
        const double found = error(settings);
        if (found < m_least) m_best = settings, m_least = found;
    }

    const Factors& m_factors;
    std::vector<FactorSample> m_samples;
    QuantiseSettings m_best;
    double m_least = 0;
};

/// Of one term alone.
QuantiseSettings best_of_term(const Factors& term, const QuantiseSettings& settings, std::vector<FactorSample> samples) {
    const bool open_weights = settings.weights.empty(), open_scale = settings.white == 0;
    QuantiseSettings start = settings;
    if (open_weights) start.weights.assign(term.terms[0].size() + 1, 1.0f);
    Search search(term, start, std::move(samples));
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
        const double before = search.least();
        if (open_weights) search.try_weights();
        if (open_scale) search.try_scales();
        if (search.least() == before) break;
    }
    return search.best();
}

}  // namespace

std::vector<QuantiseSettings> best_prescale(const Factors& factors, const QuantiseSettings& settings,
                                            std::span<const FactorSample> samples) {
    if (samples.empty())
        throw Error(ErrorCode::bad_argument,
                    "8-bit maps: there are no samples to choose prescale weights by; give the weights");
    const std::vector<FactorSample> some = some_of(samples);
    std::vector<QuantiseSettings> found;
    for (size_t term = 0; term < factors.terms.size(); ++term) {
        const Factors own = one_term(factors, term);
        std::vector<FactorSample> shares = some;
        if (factors.terms.size() > 1)
            for (FactorSample& sample : shares) sample.value = own(sample.pair);
        found.push_back(best_of_term(own, settings, std::move(shares)));
    }
    return found;
}

}  // namespace burnish
