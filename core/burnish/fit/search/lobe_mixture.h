// A grey material of one side in the making: kd and lobes, each with the space it may move in, and how its p changes with its numbers.
// Internal.
#pragma once

#include <burnish/fit/search/lobe_space.h>
#include <burnish/fit/search/transfer_samples.h>

#include <Eigen/Core>

namespace burnish {

struct LobeMixture {
    Side side = Side::reflection;
    float kd = 0;
    NumberRange kd_range{0, 1};
    std::vector<LobeParameters> lobes;
    std::vector<LobeSpace> spaces;
    double error = 0;  // sum weight |p - model|

    /// Free numbers.
    int parameters() const;
    Material material() const;
};

/// The mixture's p, grey.
std::vector<float> mixture_transfer(const LobeMixture& mixture, const TransferSamples& samples);

/// Sum weight |target - p of the mixture|.
double mixture_error(const LobeMixture& mixture, const TransferSamples& samples, const std::vector<float>& target);

/// One free number of a mixture, in units of its range.
struct Unknown {
    enum class Kind { kd, strength, r0, shape } kind;
    size_t lobe, shape;  // which, where it is one of a lobe's
    NumberRange range;

    double get(const LobeMixture& mixture) const;
    void set(LobeMixture& mixture, double unit) const;
    /// As a material's JSON has it: "kd", "ks", "kt", "r0", "mx", ...
    std::string name(const LobeMixture& mixture) const;
};

std::vector<Unknown> unknowns(const LobeMixture& mixture);

/// A mixture's p on the samples [begin, end), and its derivatives by the unknowns, a column each: exact by kd, ks and r0, differences by
/// the shape.
struct MixtureSlopes {
    Eigen::VectorXd model;
    Eigen::MatrixXd slope;
};
MixtureSlopes mixture_slopes(const LobeMixture& mixture, const std::vector<Unknown>& unknowns, const TransferSamples& samples,
                             size_t begin, size_t end);

}  // namespace burnish
