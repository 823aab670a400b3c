// The least-absolute-deviation fit of one factor: a weighted median.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace burnish {

/// A quotient of a target and what is scaled to it, with its share of the error.
struct WeightedValue {
    float value, weight;  // weight >= 0
    int index;            // of the sample it came from
};

/// The entry at which half of the weight lies below: it minimises sum weight |value - x| over x. Linear time; shuffles `values`.
/// An entry of no weight where there is none at all.
WeightedValue weighted_median(std::span<WeightedValue> values);

/// The factor s that minimises sum weight |target - s basis|, and the sample it makes exact (-1: the basis is 0 everywhere).
/// `scratch` spares the allocation.
WeightedValue scale_to(std::span<const float> target, std::span<const float> basis, std::span<const float> weight,
                       std::vector<WeightedValue>& scratch);

}  // namespace burnish
