// The SIMD lookup against CubeStack::lookup, for every instruction set this processor has.
#include "core/simd_targets.h"

#include <burnish/base/error.h>
#include <burnish/light/filter/stack_lookup.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace burnish;
using burnish_test::for_each_target;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

float noise() {
    static std::mt19937 random(4);
    return static_cast<float>(random() >> 8) * 0x1p-24f;
}

CubeStack noise_stack(std::vector<int> sizes) {
    CubeStack stack(sizes);
    for (int k = 0; k < stack.level_count(); ++k) {
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < sizes[k]; ++y)
                for (int x = 0; x < sizes[k]; ++x)
                    for (int c = 0; c < 3; ++c) stack[k].at(face, x, y)[c] = 0.1f + noise();
        stack[k].fill_borders();
    }
    return stack;
}

/// Anywhere, on edges, at corners and at face centres, of any length.
std::vector<Vec3f> directions() {
    std::vector<Vec3f> all;
    for (int i = 0; i < 3000; ++i) {
        Vec3f d(2 * noise() - 1, 2 * noise() - 1, 2 * noise() - 1);
        if (i % 3 == 1) d.y = std::copysign(d.x, d.y);
        if (i % 3 == 2) d.z = std::copysign(d.x, d.z);
        all.push_back(d * (0.1f + 3 * noise()));
    }
    for (const float x : {-1, 0, 1})
        for (const float y : {-1, 0, 1})
            for (const float z : {-1, 0, 1})
                if (x != 0 || y != 0 || z != 0) all.push_back({x, y, z});
    return all;
}

Color3f simd_lookup(const CubeStack& stack, const Vec3f& d, float level, float distortion) {
    const StackTap tap{d, level, {1, 1, 1}};
    Color3f sum;
    add_up_lookups(stack, distortion, {&tap, 1}, 1, {&sum, 1});
    return sum;
}

}  // namespace

TEST(StackLookup, EqualsTheScalarLookup) {
    std::vector<int> many(19, 3);  // more levels than fit the short table
    many[18] = 7;
    for (const std::vector<int>& sizes : {std::vector<int>{64, 32, 16, 8, 4, 2, 1}, {37, 22, 13, 5}, {9}, many}) {
        const CubeStack stack = noise_stack(sizes);
        const float last = static_cast<float>(sizes.size() - 1);
        for_each_target([&] {
            for (const float distortion : {0.0f, 1.5f})
                for (const Vec3f& d : directions()) {
                    const float level = -2 + (last + 4) * noise();
                    const Color3f truth = stack.lookup(d, level + distortion * cube_distortion(d));
                    const Color3f found = simd_lookup(stack, d, level, distortion);
                    ASSERT_LT((found - truth).length(), distortion > 0 ? 2e-4f : 2e-5f) << d << " level " << level;
                }
        });
    }
}

TEST(StackLookup, HoldsWholeLevelsAndBothEnds) {
    const CubeStack stack = noise_stack({16, 11, 4, 1});
    for_each_target([&] {
        for (const float level : {-kInf, -1.0f, 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 1e30f, kInf})
            for (const Vec3f& d : directions())
                ASSERT_LT((simd_lookup(stack, d, level, 0) - stack.lookup(d, level)).length(), 2e-5f)
                    << d << " level " << level;
    });
}

TEST(StackLookup, NeverLeavesTheStack) {
    const CubeStack stack = noise_stack({8, 5, 2});
    const auto within = [](const Color3f& c) { return c.x > 0.09f && c.x < 1.11f; };
    for_each_target([&] {
        for (const Vec3f& d : {Vec3f(kNaN, kNaN, kNaN), Vec3f(kNaN, 1, 0), Vec3f(0, 1, kNaN), Vec3f(0, 0, 0), Vec3f(kInf, 1, 0),
                               Vec3f(kInf, -kInf, kInf), Vec3f(1e-42f, 0, 0), Vec3f(3e38f, -3e38f, 3e38f)})
            for (const float level : {kNaN, -kInf, kInf, 0.5f, 9.0f})
                for (const float distortion : {0.0f, 1.5f}) EXPECT_TRUE(within(simd_lookup(stack, d, level, distortion))) << d;
    });
}

TEST(StackLookup, AddsUpWeightedRuns) {
    const CubeStack stack = noise_stack({16, 8, 4});
    const std::vector<Vec3f> d = directions();
    for (const size_t per_sum : {1, 3, 8, 13, 200}) {
        std::vector<StackTap> taps;
        for (size_t i = 0; i < 7 * per_sum; ++i) taps.push_back({d[i], 2 * noise(), {noise(), noise(), 0}});
        for_each_target([&] {
            std::vector<Color3f> sums(7);
            add_up_lookups(stack, 0, taps, per_sum, sums);
            for (size_t j = 0; j < sums.size(); ++j) {
                Color3f truth(0, 0, 0);
                for (size_t i = j * per_sum; i < (j + 1) * per_sum; ++i)
                    truth += taps[i].weight * stack.lookup(taps[i].d, taps[i].level);
                EXPECT_LT((sums[j] - truth).length(), 2e-5f * static_cast<float>(per_sum));
            }
        });
    }
}

TEST(StackLookup, RefusesMoreTexelsThanItCanCount) { EXPECT_THROW(CubeStack(std::array{20000}), Error); }
