#include <burnish/sampling/sequence.h>
#include <core/chi_square.h>

#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <random>
#include <vector>

namespace burnish {

namespace {

using Points = std::vector<Vec2f>;

Points points(uint32_t first, uint32_t count, const std::function<Vec2f(uint32_t)>& sequence) {
    Points all;
    for (uint32_t i = 0; i < count; ++i) all.push_back(sequence(first + i));
    return all;
}

/// Whether every box of 2^-a by 2^-b, a + b = k, holds exactly one of the 2^k points: a (0, k, 2)-net in base 2.
bool is_net(const Points& set, int k) {
    for (int a = 0; a <= k; ++a) {
        std::vector<int> hits(set.size());
        for (const Vec2f& p : set) {
            const auto column = static_cast<size_t>(std::ldexp(p.x, a)), row = static_cast<size_t>(std::ldexp(p.y, k - a));
            ++hits[(column << (k - a)) + row];
        }
        for (const int hit : hits)
            if (hit != 1) return false;
    }
    return true;
}

/// Warnock's formula for the squared L2 star discrepancy.
double l2_discrepancy2(const Points& set) {
    const auto n = static_cast<double>(set.size());
    double single = 0, pairs = 0;
    for (const Vec2f& p : set) {
        single += (1.0 - p.x * p.x) * (1.0 - p.y * p.y);
        for (const Vec2f& q : set) pairs += (1.0 - std::max(p.x, q.x)) * (1.0 - std::max(p.y, q.y));
    }
    return 1.0 / 9 - single / (2 * n) + pairs / (n * n);
}

/// The second Sobol' dimension by its direction numbers, v_{k+1} = v_k ^ (v_k >> 1).
uint32_t sobol_by_direction_numbers(uint32_t i) {
    uint32_t bits = 0;
    for (uint32_t v = 1u << 31; i; i >>= 1, v ^= v >> 1)
        if (i & 1) bits ^= v;
    return bits;
}

}  // namespace

TEST(Sequence, RadicalInverseMirrorsTheDigits) {
    EXPECT_EQ(radical_inverse(0), 0);
    EXPECT_EQ(radical_inverse(1), 0.5f);
    EXPECT_EQ(radical_inverse(2), 0.25f);
    EXPECT_EQ(radical_inverse(3), 0.75f);
    EXPECT_EQ(radical_inverse(6), 0.375f);
    EXPECT_LT(radical_inverse(0xffffffffu), 1);
}

TEST(Sequence, PascalsTriangleIsTheSecondSobolDimension) {
    for (const uint32_t i : {0u, 1u, 2u, 3u, 5u, 100u, 12345u, 0x80000000u, 0xdeadbeefu, 0xffffffffu})
        EXPECT_EQ(reverse_bits(sobol_pascal(i)), sobol_by_direction_numbers(i)) << i;
}

TEST(Sequence, EveryAlignedRunIsANet) {
    for (int k = 0; k <= 10; ++k)
        for (const uint32_t run : {0u, 1u, 37u}) {
            EXPECT_TRUE(is_net(points(run << k, 1u << k, sobol), k)) << k << " run " << run;
            for (const uint32_t seed : {0u, 1u, 99u, 0xffffffffu})
                EXPECT_TRUE(is_net(points(run << k, 1u << k, [&](uint32_t i) { return owen_sobol(i, seed); }), k))
                    << k << " seed " << seed;
        }
}

TEST(Sequence, HammersleyIsANet) {
    for (int k = 0; k <= 10; ++k)
        EXPECT_TRUE(is_net(points(0, 1u << k, [&](uint32_t i) { return hammersley(i, 1u << k); }), k)) << k;
}

TEST(Sequence, SpreadsFarMoreEvenlyThanChance) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    const uint32_t n = 256;
    const double chance = l2_discrepancy2(points(0, n, [&](uint32_t) { return Vec2f(uniform(random), uniform(random)); }));
    EXPECT_LT(l2_discrepancy2(points(0, n, sobol)), 0.1 * chance);
    EXPECT_LT(l2_discrepancy2(points(0, n, [&](uint32_t i) { return hammersley(i, n); })), 0.1 * chance);
    for (const uint32_t seed : {0u, 1u, 2u, 3u})
        EXPECT_LT(l2_discrepancy2(points(0, n, [&](uint32_t i) { return owen_sobol(i, seed); })), 0.02 * chance) << seed;
}

TEST(Sequence, EachScrambledPointIsUniformOverSeeds) {
    for (const uint32_t index : {0u, 1u, 2u, 7u, 100u}) {
        uint32_t seed = 0;
        const auto draw = [&] {
            const Vec2f p = owen_sobol(index, seed++);
            return std::optional(SquarePoint{p.x, p.y});
        };
        EXPECT_GT(chi_square(100000, 16, draw, [](SquarePoint) { return 1.0; }).p_value, 0.001) << index;
    }
}

TEST(Sequence, NeighbouringSeedsAreIndependent) {
    for (const uint32_t index : {0u, 3u, 50u})
        for (const uint32_t gap : {1u, 2u, 64u, 1u << 16}) {
            uint32_t seed = 0;
            const auto draw = [&] {
                const SquarePoint p{owen_sobol(index, seed).x, owen_sobol(index, seed + gap).x};
                ++seed;
                return std::optional(p);
            };
            EXPECT_GT(chi_square(100000, 16, draw, [](SquarePoint) { return 1.0; }).p_value, 0.0005) << index << " gap " << gap;
        }
}

TEST(Sequence, ScrambledEstimatesHaveNoBiasAndLittleVariance) {
    const int seeds = 400;
    const uint32_t n = 64;
    double sum = 0, sum2 = 0;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        double mean = 0;
        for (uint32_t i = 0; i < n; ++i) {
            const Vec2f p = owen_sobol(i, seed);
            mean += std::exp(p.x + p.y) / n;
        }
        sum += mean, sum2 += mean * mean;
    }
    const double exact = std::pow(std::exp(1.0) - 1, 2), average = sum / seeds,
                 deviation = std::sqrt(sum2 / seeds - average * average);
    const double random_deviation = std::sqrt((std::pow((std::exp(2.0) - 1) / 2, 2) - exact * exact) / n);
    EXPECT_NEAR(average, exact, 4 * deviation / std::sqrt(seeds));
    EXPECT_LT(deviation, 0.1 * random_deviation);
}

TEST(Sequence, HashTurnsHalfTheBits) {
    for (int bit = 0; bit < 32; ++bit) {
        int turned = 0;
        for (uint32_t i = 0; i < 1000; ++i) turned += std::popcount(hash_bits(i) ^ hash_bits(i ^ (1u << bit)));
        EXPECT_NEAR(turned / 32000.0, 0.5, 0.02) << bit;
    }
    EXPECT_NE(hash_bits(1, 2), hash_bits(2, 1));
}

}  // namespace burnish
