// One side of a material from its samples: kd from the histogram, then lobe after lobe, each searched for in what the others leave,
// all polished together, until another one does not pay.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/search/lobe_mixture.h>

namespace burnish {

/// A side fitted with 0, 1, 2, ... lobes, and how many of them the data needs.
struct SideFit {
    std::vector<LobeMixture> by_lobes;  // [k]: with k lobes; reflection starts with kd alone, transmission with nothing
    size_t chosen = 0;
    double noise = 0;  // the part of the error that is the table's own noise

    const LobeMixture& best() const { return by_lobes[chosen]; }
};

/// Rule for one more lobe: it lowers the error by more than kGainPerNumber per number it adds and by more than fitting that many
/// numbers to noise would, and it shows on as many samples as it has numbers. The first is what tells a lobe from a correction to
/// one; the others matter for small tables. The error is that of all samples or, if it falls by more there, of all but the hundredth
/// that is missed most: highlights narrower than a table's grid leave readings that no lobe meets and that drown everything else.
inline constexpr double kGainPerNumber = 0.01;

/// Grey. `round`: one width per lobe. Throws Error(cancelled), and Error(bad_argument) for bounds that cannot be.
SideFit fit_side(const TransferSamples& samples, Side side, ModelId model, bool round, const FitSettings& settings,
                 const Progress& progress);

}  // namespace burnish
