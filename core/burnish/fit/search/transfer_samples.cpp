#include <burnish/base/parallel.h>
#include <burnish/fit/search/lobe_transfer.h>
#include <burnish/fit/search/transfer_samples.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace burnish {
namespace {

constexpr size_t kBatch = 4096;

/// Numbers directions in the order they turn up; those within a float's rounding of each other are one.
class DirectionNumbers {
public:
    int operator()(const Vec3f& w) {
        const auto rounded = [](float x) { return std::lround(x * 1e5f); };
        const auto [entry, fresh] = m_numbers.try_emplace({rounded(w.x), rounded(w.y), rounded(w.z)}, size());
        if (fresh) m_directions.push_back(w);
        return entry->second;
    }
    int size() const { return static_cast<int>(m_directions.size()); }
    std::vector<Vec3f> directions() && { return std::move(m_directions); }

private:
    std::map<std::array<long, 3>, int> m_numbers;
    std::vector<Vec3f> m_directions;
};

bool on_side(const BrdfSample& sample, Side side) {
    return (sample.wi.z < 0) == (side == Side::transmission) && sample.wi.z != 0 && sample.wo.z > 0;
}

/// The samples of one side with the incident direction first.
struct Pairs {
    std::vector<const BrdfSample*> samples;
    std::vector<int> incident;
    std::vector<Vec3f> directions;
    bool wi_is_incident;

    Pairs(std::span<const BrdfSample> all, Side side) {
        DirectionNumbers by_wi, by_wo;
        std::vector<int> wi_numbers, wo_numbers;
        for (const BrdfSample& sample : all) {
            if (!on_side(sample, side)) continue;
            samples.push_back(&sample);
            wi_numbers.push_back(by_wi(sample.wi));
            wo_numbers.push_back(by_wo(sample.wo));
        }
        wi_is_incident = by_wi.size() <= by_wo.size();
        incident = wi_is_incident ? std::move(wi_numbers) : std::move(wo_numbers);
        directions = wi_is_incident ? std::move(by_wi).directions() : std::move(by_wo).directions();
    }

    const Vec3f& outgoing(size_t i) const { return wi_is_incident ? samples[i]->wo : samples[i]->wi; }
    Color3f p(size_t i) const { return samples[i]->f * std::abs(outgoing(i).z); }
    float solid_angle(size_t i) const { return std::sqrt(std::max(0.0f, 1 - outgoing(i).z * outgoing(i).z)); }
};

/// Makes the weights sum to 1; returns what they summed to.
double normalise(std::vector<float>& weight) {
    const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
    if (sum > 0)
        for (float& w : weight) w = static_cast<float>(w / sum);
    return sum;
}

/// Samples to be of the same table.
TransferSamples without_samples(const TransferSamples& from) {
    TransferSamples result;
    result.incident_directions = from.incident_directions;
    result.wi_is_incident = from.wi_is_incident;
    result.share = from.share;
    return result;
}

void copy_sample(const TransferSamples& from, size_t j, float weight, TransferSamples& to) {
    to.wo.push_back(from.wo[j]);
    to.wi.push_back(from.wi[j]);
    to.cosine.push_back(from.cosine[j]);
    to.weight.push_back(weight);
    to.p.push_back(from.p[j]);
    to.incident.push_back(from.incident[j]);
}

}  // namespace

TransferSamples transfer_samples(std::span<const BrdfSample> samples, Side side) {
    const Pairs pairs(samples, side);
    TransferSamples result;
    result.incident_directions = pairs.directions;
    result.wi_is_incident = pairs.wi_is_incident;
    for (size_t i = 0; i < pairs.samples.size(); ++i) {
        const Color3f p = pairs.p(i);
        if (!(p.x + p.y + p.z > 0)) continue;
        const Vec3f& incident = pairs.directions[static_cast<size_t>(pairs.incident[i])];
        result.wo.push_back(pairs.samples[i]->wo);
        result.wi.push_back(pairs.samples[i]->wi);
        result.cosine.push_back(std::abs(pairs.outgoing(i).z));
        result.weight.push_back(pairs.solid_angle(i) * std::abs(incident.z));
        result.p.push_back(p);
        result.incident.push_back(pairs.incident[i]);
    }
    result.share = normalise(result.weight);
    return result;
}

TransferSamples thinned(const TransferSamples& samples, size_t count) {
    if (samples.size() <= count) return samples;
    const std::vector<float> p = grey(samples.p);
    double energy = 0;
    for (size_t j = 0; j < samples.size(); ++j) energy += static_cast<double>(samples.weight[j]) * p[j];
    TransferSamples result = without_samples(samples);
    double passed = 0.5;
    for (size_t j = 0; j < samples.size(); ++j) {
        const double share = 0.5 * samples.weight[j] * (p[j] / energy + 1);
        const double chance = std::min(1.0, share * static_cast<double>(count));
        const double before = passed;
        passed += chance;
        if (std::floor(passed) > std::floor(before))
            copy_sample(samples, j, static_cast<float>(samples.weight[j] / chance), result);
    }
    normalise(result.weight);
    return result;
}

std::vector<float> grey(std::span<const Color3f> p) {
    std::vector<float> result(p.size());
    std::ranges::transform(p, result.begin(), [](const Color3f& c) { return (c.x + c.y + c.z) / 3; });
    return result;
}

std::vector<Color3f> model_transfer(const Material& material, const TransferSamples& samples, Side side) {
    std::vector<Color3f> p(samples.size(), Color3f(0));
    const size_t batches = (samples.size() + kBatch - 1) / kBatch;
    for_each_index(static_cast<int>(batches), [&](int batch) {
        const size_t begin = static_cast<size_t>(batch) * kBatch, end = std::min(begin + kBatch, samples.size());
        if (side == Side::reflection)
            for (size_t j = begin; j < end; ++j) p[j] = material.kd * (samples.cosine[j] / kPi);
        for (const LobeParameters& lobe : material.lobes) {
            if (lobe.side != side) continue;
            const Color3f factor = lobe.tint * lobe.strength;
            for_each_transfer(lobe, samples, begin, end, [&](size_t j, const Color3f& value) { p[j] += factor * value; });
        }
    });
    return p;
}

Color3f l1_error(std::span<const Color3f> model, const TransferSamples& samples) {
    double error[3] = {};
    for (size_t j = 0; j < samples.size(); ++j)
        for (int c = 0; c < 3; ++c) error[c] += samples.weight[j] * std::abs(samples.p[j][c] - model[j][c]);
    return {static_cast<float>(error[0]), static_cast<float>(error[1]), static_cast<float>(error[2])};
}

std::vector<IncidentAlbedo> measured_albedo(std::span<const BrdfSample> samples, Side side) {
    const Pairs pairs(samples, side);
    std::vector<Imath::V3d> sum(pairs.directions.size(), Imath::V3d(0));
    std::vector<double> solid_angle(pairs.directions.size());
    for (size_t i = 0; i < pairs.samples.size(); ++i) {
        const size_t incident = static_cast<size_t>(pairs.incident[i]);
        sum[incident] += Imath::V3d(pairs.p(i)) * static_cast<double>(pairs.solid_angle(i));
        solid_angle[incident] += pairs.solid_angle(i);
    }
    std::vector<IncidentAlbedo> result;
    for (size_t i = 0; i < sum.size(); ++i)
        if (solid_angle[i] > 0)
            result.push_back({pairs.directions[i], Color3f(Vec3f(sum[i] * (2 * std::numbers::pi / solid_angle[i])))});
    return result;
}

}  // namespace burnish
