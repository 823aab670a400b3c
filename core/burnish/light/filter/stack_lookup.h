// Filtered lookups in bulk, with the widest vectors the processor has: sums of weighted lookups in a CubeStack, or each by itself.
#pragma once

#include <burnish/light/filter/cube_stack.h>

#include <array>
#include <span>

namespace burnish {

/// A lookup: direction of any length, level without distortion, and what the radiance is multiplied by.
struct StackTap {
    Vec3f d;
    float level;
    Color3f weight;
};

inline constexpr size_t kMostTapsPerSum = 256;

/// sums[j] = sum of weight * stack.lookup(d, level + distortion * cube_distortion(d)) over the `per_sum` taps from
/// j * per_sum on; 1 <= per_sum <= kMostTapsPerSum. Any direction and level is safe. The stack must not be empty.
void add_up_lookups(const CubeStack& stack, float distortion, std::span<const StackTap> taps, size_t per_sum,
                    std::span<Color3f> sums);

/// A lookup without a weight.
struct StackPlace {
    Vec3f d;
    float level;
};

/// rgba[i] = stack.lookup_rgba(d, level) of places[i], within rounding, times `gain` channel by channel. As safe.
void look_up(const CubeStack& stack, std::span<const StackPlace> places, const std::array<float, 4>& gain,
             std::span<std::array<float, 4>> rgba);

}  // namespace burnish
