// How well one list of numbers foretells another.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace burnish {

/// Places of the values in their order, from 0.
inline std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<size_t> order(values.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::stable_sort(order, {}, [&](size_t i) { return values[i]; });
    std::vector<double> rank(values.size());
    for (size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
    return rank;
}

/// Spearman's.
inline double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> x = ranks(a), y = ranks(b);
    const double middle = (static_cast<double>(a.size()) - 1) / 2;
    double xy = 0, xx = 0;
    for (size_t i = 0; i < a.size(); ++i) xy += (x[i] - middle) * (y[i] - middle), xx += (x[i] - middle) * (x[i] - middle);
    return xy / xx;
}

/// Share of entries below half of the truth, once the prediction has been scaled so that its median ratio is 1 (if wanted).
inline double share_below_half(const std::vector<double>& predicted, const std::vector<double>& truth, bool scaled) {
    std::vector<double> ratio;
    for (size_t i = 0; i < truth.size(); ++i)
        if (truth[i] > 0) ratio.push_back(predicted[i] / truth[i]);
    std::ranges::sort(ratio);
    const double half = 0.5 * (scaled ? ratio[ratio.size() / 2] : 1.0);
    return static_cast<double>(std::ranges::count_if(ratio, [&](double r) { return r < half; })) /
           static_cast<double>(ratio.size());
}

}  // namespace burnish
