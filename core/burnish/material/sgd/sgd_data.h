// What an SGD lobe computes once from its numbers: shadowing and the slopes of its three channels taken together.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/material/sgd/fitted_shadowing.h>
#include <burnish/material/sgd/slope_table.h>
#include <burnish/material/sgd/smith_table.h>

#include <memory>
#include <optional>
#include <vector>

namespace burnish {

/// One colour channel of an SGD lobe.
struct SgdChannel {
    float alpha, p, log_scale;  // ShiftedGamma
    std::optional<FittedShadowing> fitted;
    std::optional<SmithTable> smith;  // where there is no fit

    /// P22 of the squared slope x.
    float density(float x) const {
        const float shifted = alpha * alpha + x;
        return std::exp(log_scale - shifted / alpha - p * std::log(shifted));
    }
    /// Share of the microfacets facing a direction that it sees, at cot theta >= 0.
    float G1(float cot_theta) const { return fitted ? fitted->G1(std::atan2(1.0f, cot_theta)) : smith->G1(cot_theta); }
};

struct SgdData final : LobeData {
    SgdData(const std::vector<float>& extra, const Color3f& shares);

    std::vector<float> extra;  // what this was made from
    Color3f shares;            // of the channels in `slopes`
    std::vector<SgdChannel> channels;
    std::optional<SlopeTable> slopes;
    float own_width;  // of Gaussian slopes with the same median
};

/// Shares of the channels in what a lobe reflects, each at least 1 %: for patterns and sampling.
Color3f channel_shares(const LobeParameters& lobe);

/// The lobe's own data if it was made from its numbers, else new ones.
std::shared_ptr<const SgdData> sgd_data(const LobeParameters& lobe);

}  // namespace burnish
