// The hierarchical grid search for one lobe: a coarse grid over the numbers of its shape, then finer ones around each of the best
// valleys. Strength and r0 are not searched but solved for, exactly, at every point.
// Source: Walkthrough 3.4.1, where all five numbers are searched and only the best point is followed.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/search/lobe_space.h>
#include <burnish/fit/search/transfer_samples.h>

namespace burnish {

struct FoundLobe {
    LobeParameters lobe;
    double error = 0;  // sum weight |target - p|
};

/// Whether a lobe of `numbers` numbers is a visible part of what was measured on at least as many samples. One for a single bright
/// reading, narrower than the table can tell, is not.
bool is_borne_out(std::span<const float> lobe, std::span<const float> measured, int numbers);

/// Up to `valleys` lobes of different shape that fit `target`, one value a sample, best first, all of them borne out by the samples. Empty
/// where there is none. The same for any number of threads; throws Error(cancelled).
std::vector<FoundLobe> search_lobe(const LobeSpace& space, const TransferSamples& samples, const std::vector<float>& target,
                                   int valleys, const Progress& progress);

}  // namespace burnish
