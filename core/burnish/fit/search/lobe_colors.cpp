#include <burnish/fit/search/lobe_colors.h>
#include <burnish/fit/search/weighted_median.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kRounds = 12;  // of one factor after the other; kd and lobes overlap little

/// p of kd = 1 (if it belongs to this side) and of each lobe on it at tint 1: what a channel is a sum of.
struct Parts {
    std::vector<std::vector<Color3f>> p;
    std::vector<size_t> lobes;  // indices into Material::lobes, one a part after the diffuse one
    bool diffuse;

    Parts(const Material& material, const TransferSamples& samples, Side side) : diffuse(side == Side::reflection) {
        Material part;
        if (diffuse) {
            part.kd = Color3f(1);
            p.push_back(model_transfer(part, samples, side));
        }
        for (size_t n = 0; n < material.lobes.size(); ++n) {
            if (material.lobes[n].side != side) continue;
            part = {};
            part.lobes = {material.lobes[n]};
            part.lobes.front().tint = Color3f(1);
            p.push_back(model_transfer(part, samples, side));
            lobes.push_back(n);
        }
    }
};

/// Factors of the parts in one channel, from `factors` on; the first is kept in `first_range`. A channel that is 0 where others are not
/// is dark, not unrecorded: saturated colours have such.
void fit_channel(const Parts& parts, const TransferSamples& samples, int channel, NumberRange first_range,
                 std::vector<float>& factors) {
    std::vector<float> left(samples.size()), basis(samples.size());
    for (size_t j = 0; j < left.size(); ++j) {
        left[j] = samples.p[j][channel];
        for (size_t i = 0; i < factors.size(); ++i) left[j] -= factors[i] * parts.p[i][j][channel];
    }
    std::vector<WeightedValue> scratch;
    for (int round = 0; round < kRounds; ++round) {
        for (size_t i = 0; i < factors.size(); ++i) {
            for (size_t j = 0; j < left.size(); ++j) {
                basis[j] = parts.p[i][j][channel];
                left[j] += factors[i] * basis[j];
            }
            factors[i] = std::max(0.0f, scale_to(left, basis, samples.weight, scratch).value);
            if (i == 0 && parts.diffuse)
                factors[i] = std::clamp(factors[i], static_cast<float>(first_range.min), static_cast<float>(first_range.max));
            for (size_t j = 0; j < left.size(); ++j) left[j] -= factors[i] * basis[j];
        }
    }
}

bool is_grey(const TransferSamples& samples) {
    return std::ranges::all_of(samples.p, [](const Color3f& p) { return p.x == p.y && p.y == p.z; });
}

}  // namespace

void fit_colors(Material& material, const TransferSamples& samples, Side side, NumberRange kd_range) {
    if (is_grey(samples)) return;
    const Parts parts(material, samples, side);
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<float> factors(parts.p.size(), 1);
        if (parts.diffuse) factors.front() = material.kd[channel];
        fit_channel(parts, samples, channel, kd_range, factors);
        const size_t first = parts.diffuse ? 1 : 0;
        if (parts.diffuse) material.kd[channel] = factors.front();
        for (size_t i = 0; i < parts.lobes.size(); ++i) material.lobes[parts.lobes[i]].tint[channel] = factors[first + i];
    }
}

}  // namespace burnish
