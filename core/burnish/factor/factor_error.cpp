#include <burnish/factor/factor_error.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

/// Sums over some of the samples.
struct Sums {
    FactorError error;
    int64_t count = 0, relative_count = 0;

    void add(float is, float should_be) {
        const double difference = std::fabs(static_cast<double>(is) - should_be);
        error.average_absolute += difference;
        error.max_absolute = std::max(error.max_absolute, difference);
        error.rms += difference * difference;
        ++count;
        if (should_be == 0) return;
        error.average_relative += difference / std::fabs(should_be);
        error.max_relative = std::max(error.max_relative, difference / std::fabs(should_be));
        ++relative_count;
    }

    void add(const Sums& other) {
        error.average_absolute += other.error.average_absolute;
        error.max_absolute = std::max(error.max_absolute, other.error.max_absolute);
        error.average_relative += other.error.average_relative;
        error.max_relative = std::max(error.max_relative, other.error.max_relative);
        error.rms += other.error.rms;
        count += other.count;
        relative_count += other.relative_count;
    }

    FactorError averages() const {
        FactorError average = error;
        if (count > 0) {
            average.average_absolute /= static_cast<double>(count);
            average.rms = std::sqrt(average.rms / static_cast<double>(count));
        }
        if (relative_count > 0) average.average_relative /= static_cast<double>(relative_count);
        return average;
    }
};

}  // namespace

FactorError factor_error(const std::function<Color3f(const DirectionPair&)>& function, std::span<const FactorSample> samples) {
    constexpr size_t kChunk = 4096;
    std::vector<Sums> parts((samples.size() + kChunk - 1) / kChunk);
    for_each_index(static_cast<int>(parts.size()), [&](int part) {
        for (const FactorSample& sample : samples.subspan(part * kChunk, std::min(kChunk, samples.size() - part * kChunk))) {
            const Color3f value = function(sample.pair);
            for (int channel = 0; channel < 3; ++channel) parts[part].add(value[channel], sample.value[channel]);
        }
    });
    Sums whole;
    for (const Sums& part : parts) whole.add(part);
    return whole.averages();
}

}  // namespace burnish
