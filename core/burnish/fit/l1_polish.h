// All numbers of all lobes and kd at once, from a good start to the bottom of the sum of absolute errors.
//
// Iteratively re-weighted least squares in Levenberg & Marquardt's form: residuals weigh w / max(|r|, epsilon), with epsilon a
// shrinking share of what the residuals are like. A step counts only if it lowers the true error, so the result is never worse than
// the start. Derivatives by kd, ks and r0 are exact, the ones by the shape differences.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/lobe_space.h>
#include <burnish/fit/transfer_samples.h>

namespace burnish {

/// A grey material of one side in the making: kd and lobes, each with the space it may move in.
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

/// The mixture moved downhill, `error` included. The same for any number of threads; throws Error(cancelled).
LobeMixture polished(LobeMixture mixture, const TransferSamples& samples, const std::vector<float>& target,
                     const Progress& progress);

}  // namespace burnish
