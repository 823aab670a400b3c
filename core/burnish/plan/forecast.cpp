#include <burnish/plan/forecast.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

double mean_square(double db) { return std::pow(10.0, -db / 10); }

double octaves(int a, int b) { return std::abs(std::log2(static_cast<double>(a) / b)); }

}  // namespace

double joint_db(double a, double b) { return -10 * std::log10(mean_square(a) + mean_square(b)); }

void Forecast::learn_sparse(const Configuration& configuration, float safety, double db) {
    constexpr double kLeastShare = 0.05;  // of the error, that is interpolation's whatever the check says
    const double all = mean_square(db), own = std::max(all - mean_square(dense(configuration, 0)), kLeastShare * all);
    m_sparse_shift = -10 * std::log10(own) - predicted_sparse(safety).mean;
}

/// Of all lobes together: their errors add up, each as large as the others under the probe.
PredictedGain Forecast::gain(const Configuration& configuration) const {
    double squares = 0, deviation = 0;
    for (const LobeParameters& lobe : m_material->lobes) {
        const PredictedGain own = predicted_gain(lobe, configuration);
        squares += mean_square(own.mean), deviation += own.deviation;
    }
    const double count = std::max<double>(1, static_cast<double>(m_material->lobes.size()));
    return {static_cast<float>(-10 * std::log10(std::max(squares / count, 1e-12))), static_cast<float>(deviation / count)};
}

const Configuration* Forecast::nearest_of_family(const Configuration& configuration) const {
    const Configuration* nearest = nullptr;
    for (const auto& [known, db] : m_measured) {
        if (known.estimator != configuration.estimator) continue;
        const auto away = [&](const Configuration& c) { return octaves(c.samples, configuration.samples); };
        if (!nearest || away(known) < away(*nearest)) nearest = &known;
    }
    return nearest;
}

double Forecast::dense(const Configuration& configuration, double caution) const {
    constexpr double kDeviationAnOctave = 1.5;  // within a family; by the table's own columns
    if (const auto known = m_measured.find(configuration); known != m_measured.end()) return known->second;
    const Configuration* anchor = nearest_of_family(configuration);
    const PredictedGain own = gain(configuration);
    if (!anchor) return m_measured.at(kProbe) + own.mean - caution * own.deviation;
    const double deviation =
        std::min<double>(own.deviation, kDeviationAnOctave * octaves(anchor->samples, configuration.samples));
    return m_measured.at(*anchor) + own.mean - gain(*anchor).mean - caution * deviation;
}

double Forecast::total(const Configuration& configuration, float safety, double caution) const {
    const double own = dense(configuration, caution);
    if (safety <= 0) return own;
    const PredictedGain sparse = predicted_sparse(safety);
    return joint_db(own, sparse.mean + m_sparse_shift - caution * sparse.deviation);
}

}  // namespace burnish
