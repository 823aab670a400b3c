#include <burnish/sampling/sample_ladder.h>

#include <algorithm>
#include <cmath>

namespace burnish {

std::vector<int> sample_ladder(int most) {
    std::vector<int> ladder{most};
    for (double count = most / 1.5; count > 1.25 * kFewestLookups; count /= 1.5)
        ladder.push_back(static_cast<int>(std::lround(count)));
    if (most > kFewestLookups) ladder.push_back(kFewestLookups);
    std::ranges::reverse(ladder);
    return ladder;
}

float full_deviation(EstimatorKind kind) { return kind == EstimatorKind::preconvolved ? 3.0f : 4.0f; }

size_t ladder_rung(const std::vector<int>& ladder, float deviation, float full) {
    const float wanted = static_cast<float>(ladder.back()) * std::min(deviation / full, 1.0f) * (5.0f / 6);
    const auto rung = std::ranges::find_if(ladder, [&](int count) { return static_cast<float>(count) >= wanted; });
    return static_cast<size_t>(rung - ladder.begin());
}

}  // namespace burnish
