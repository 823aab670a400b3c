// The median, on which everything here rests that wrong pixels must not pull.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace burnish {

/// Upper median; infinite for no values, so that what is judged by it fails.
inline double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::infinity();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace burnish
