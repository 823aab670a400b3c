#include <burnish/light/filter/gaussian_levels.h>

#include <burnish/light/filter/gaussian_width.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {
namespace {

constexpr double kTexelPerSigma[] = {0.75, 0.5};                      // at a face's centre, of fine and of dense levels
constexpr double kStep[] = {std::numbers::sqrt2, 1.189207115002721};  // from one width to the next: 2^(1/2) and 2^(1/4)
constexpr double kDenseSigma =
    0.028;                         // from here on levels are small, so they can be dense: blends of two are then true Gaussians
constexpr double kTapRatio = 1.5;  // a level comes by taps from one that is at most so much narrower, and at least kStep[1]
constexpr double kShrunkTexels = 3.99;  // a sum over the shrunk map needs so many of its texels to a sigma
constexpr double kLastShrunk = 0.085;   // the widest such level: Gaussians beyond it have no small caps (gaussian_cap.h)
constexpr double kWidestSigma = 0.99;   // the last level is the first beyond this
constexpr double kSumSigma = 0.35;      // from here on, a Gaussian of a Gaussian is no Gaussian: sums over a much finer level
constexpr double kTooWideSigma = 1.5;
constexpr double kSumRatio = 2.8;  // by sums, from one that is at least so much narrower
constexpr int kSmallestSize = 16;

double texel_width(int size) { return 2.0 / size; }

/// Level 0 is the map: texel areas and the tent, over the whole sphere.
GaussianLevel map_level(int size) {
    const double versine = 0.25 * texel_width(size) * texel_width(size) * kMeanTexelMetric;
    return {size, sigma_of_versine(versine), versine};
}

std::vector<GaussianLevel> levels_of_map(int map_size) {
    std::vector<GaussianLevel> levels = {map_level(map_size)};
    double sigma = texel_width(map_size);
    while (levels.back().sigma < kWidestSigma && sigma < kTooWideSigma) {
        const bool dense = sigma >= kDenseSigma;
        const int fitting =
            levels.size() == 1 ? map_size : 2 * static_cast<int>(std::ceil(1.0 / (kTexelPerSigma[dense] * sigma)));
        levels.push_back({std::max(kSmallestSize, fitting), sigma, versine_of_sigma(sigma)});
        sigma *= kStep[dense];
    }
    return levels;
}

/// How often the map can be halved until its texels are as wide as a level of `sigma` allows.
int halvings_for(int map_size, double sigma) {
    int halvings = 0;
    while (map_size % 2 == 0 && sigma >= kShrunkTexels * texel_width(map_size / 2)) map_size /= 2, ++halvings;
    return halvings;
}

/// The last level at least `ratio` narrower than level k; the map if there is none.
int narrower(const std::vector<GaussianLevel>& levels, int k, double ratio) {
    int from = k - 1;
    while (from > 0 && levels[from].sigma * ratio > levels[k].sigma) --from;
    return from;
}

}  // namespace

std::vector<GaussianLevel> gaussian_levels(int map_size) {
    using enum GaussianLevel::Source;
    std::vector<GaussianLevel> levels = levels_of_map(map_size);
    int start = 1, halvings = 0;  // of the levels that come one from the other
    for (int k = 2; k < static_cast<int>(levels.size()); ++k) {
        GaussianLevel& level = levels[k];
        if (level.sigma >= kSumSigma) {
            level.from = narrower(levels, k, kSumRatio);
            level.source = level.from > 0 ? sums : map;
            continue;
        }
        const int fitting = halvings_for(map_size, level.sigma);
        if (level.sigma >= kDenseSigma && fitting > halvings && level.sigma < kLastShrunk) {
            start = k, halvings = level.halvings = fitting;
            continue;
        }
        const bool near = k - 2 >= start && level.sigma <= kTapRatio * levels[k - 2].sigma;
        level.source = k > 2 ? taps : sums;
        level.from = near && k > 2 ? k - 2 : k - 1;
    }
    return levels;
}

}  // namespace burnish
