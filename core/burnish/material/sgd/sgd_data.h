// What an SGD lobe computes once from its numbers: shadowing and the slopes of its three channels taken together.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/material/sgd/fitted_shadowing.h>
#include <burnish/material/sgd/slope_table.h>
#include <burnish/material/sgd/smith_table.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace burnish {

/// One colour channel of an SGD lobe.
struct SgdChannel {
    float shift, inv_decay, p, log_scale;  // ShiftedGamma
    std::optional<FittedShadowing> fitted;
    std::optional<SmithTable> smith;  // where there is no fit

    void set_slopes(const ShiftedGamma& slopes);
    /// P22 of the squared slope x.
    float density(float x) const { return std::exp(log_scale - x * inv_decay - p * std::log(shift + x)); }
    /// Share of the microfacets facing a direction that it sees, at cot theta >= 0.
    float G1(float cot_theta) const { return fitted ? fitted->G1(std::atan2(1.0f, cot_theta)) : smith->G1(cot_theta); }
};

struct SgdData final : LobeData {
    /// `numbers`: as in LobeParameters::extra.
    explicit SgdData(const std::vector<float>& numbers);
    /// Slopes blurred as ShiftedGamma::blurred has it, by `variance` in the slopes' own measure.
    SgdData(const SgdData& sharp, float variance);

    std::vector<float> extra;  // what this was made from
    std::vector<SgdChannel> channels;
    std::optional<SlopeTable> slopes;  // of the mean of the channels
    float own_width;                   // of Gaussian slopes with the same median

    /// Density of the squared slope x, mean of the channels.
    float density(float x) const { return (channels[0].density(x) + channels[1].density(x) + channels[2].density(x)) / 3; }

private:
    void tabulate_slopes();
};

/// The lobe's own data if it was made from its numbers, else new ones.
std::shared_ptr<const SgdData> sgd_data(const LobeParameters& lobe);

}  // namespace burnish
