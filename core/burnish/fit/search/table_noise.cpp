#include <burnish/base/parallel.h>
#include <burnish/fit/search/table_noise.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {
namespace {

constexpr size_t kProbes = 2048;

/// The sample of the same incident direction whose outgoing direction is nearest to that of `j`, j itself if it is alone.
size_t nearest(const TransferSamples& samples, const std::vector<size_t>& group, size_t j) {
    size_t best = j;
    float best_cosine = -2;
    for (const size_t other : group) {
        if (other == j) continue;
        const float cosine = samples.outgoing(other).dot(samples.outgoing(j));
        if (cosine > best_cosine) best = other, best_cosine = cosine;
    }
    return best;
}

}  // namespace

double noise_level(const TransferSamples& samples, const std::vector<float>& model) {
    if (samples.size() == 0) return 0;
    std::vector<std::vector<size_t>> groups(samples.incident_directions.size());
    for (size_t j = 0; j < samples.size(); ++j) groups[static_cast<size_t>(samples.incident[j])].push_back(j);
    const std::vector<float> p = grey(samples.p);
    const size_t stride = std::max<size_t>(1, samples.size() / kProbes), probes = samples.size() / stride;
    std::vector<double> difference(probes), weight(probes);
    for_each_index(static_cast<int>(probes), [&](int i) {
        const size_t probe = static_cast<size_t>(i), j = probe * stride;
        const size_t other = nearest(samples, groups[static_cast<size_t>(samples.incident[j])], j);
        difference[probe] = std::abs((p[j] - model[j]) - (p[other] - model[other])) / std::numbers::sqrt2;
        weight[probe] = samples.weight[j];
    });
    double sum = 0, all = 0;
    for (size_t i = 0; i < probes; ++i) sum += weight[i] * difference[i], all += weight[i];
    return all > 0 ? sum / all : 0;
}

}  // namespace burnish
