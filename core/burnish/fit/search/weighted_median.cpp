#include <burnish/fit/search/weighted_median.h>

#include <algorithm>
#include <cmath>

namespace burnish {

WeightedValue weighted_median(std::span<WeightedValue> values) {
    double half = 0;
    for (const WeightedValue& v : values) half += 0.5 * v.weight;
    if (!(half > 0)) return {0, 0, -1};
    const auto by_value = [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; };
    while (values.size() > 1) {
        const size_t middle = values.size() / 2;
        std::ranges::nth_element(values, values.begin() + middle, by_value);
        double below = 0;
        for (const WeightedValue& v : values.first(middle)) below += v.weight;
        if (below >= half) {
            values = values.first(middle);
        } else {
            half -= below;
            values = values.subspan(middle);
            if (values.front().weight >= half) return values.front();
            half -= values.front().weight;
            values = values.subspan(std::min<size_t>(1, values.size() - 1));
        }
    }
    return values.front();
}

WeightedValue scale_to(std::span<const float> target, std::span<const float> basis, std::span<const float> weight,
                       std::vector<WeightedValue>& scratch) {
    scratch.clear();
    for (size_t j = 0; j < target.size(); ++j) {
        const float share = weight[j] * std::abs(basis[j]);
        if (share > 0) scratch.push_back({target[j] / basis[j], share, static_cast<int>(j)});
    }
    return weighted_median(scratch);
}

}  // namespace burnish
