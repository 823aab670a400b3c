#include <burnish/factor/factor_error.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

/// Sums over some of the samples.
struct Sums {
    FactorError error;
    int64_t count = 0, relative_count = 0;

    void add(float is, float should_be, double floor) {
        const double difference = std::fabs(static_cast<double>(is) - should_be);
        error.average_absolute += difference;
        error.max_absolute = std::max(error.max_absolute, difference);
        error.rms += difference * difference;
        ++count;
        const double size = std::fabs(should_be) + floor;
        if (size == 0) return;
        error.average_relative += difference / size;
        error.max_relative = std::max(error.max_relative, difference / size);
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

double mean_of(std::span<const FactorSample> samples) {
    double sum = 0;
    for (const FactorSample& sample : samples) sum += static_cast<double>(sample.value.x) + sample.value.y + sample.value.z;
    return sum / (3.0 * static_cast<double>(std::max<size_t>(samples.size(), 1)));
}

}  // namespace

FactorError factor_error(const PairFunction& function, std::span<const FactorSample> samples, float bias) {
    const double floor = bias > 0 ? bias * mean_of(samples) : 0;
    constexpr size_t kChunk = 4096;
    std::vector<Sums> parts((samples.size() + kChunk - 1) / kChunk);
    for_each_index(static_cast<int>(parts.size()), [&](int part) {
        for (const FactorSample& sample : samples.subspan(part * kChunk, std::min(kChunk, samples.size() - part * kChunk))) {
            const Color3f value = function(sample.pair);
            for (int channel = 0; channel < 3; ++channel) parts[part].add(value[channel], sample.value[channel], floor);
        }
    });
    Sums whole;
    for (const Sums& part : parts) whole.add(part);
    return whole.averages();
}

}  // namespace burnish
