#include <burnish/sampling/lobe_pattern.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace burnish;

namespace {

double total_area(const LobePattern& pattern) {
    double sum = 0;
    for (const PatternSample& s : pattern) sum += s.area;
    return sum;
}

double density(const PatternSample& s) { return std::exp(-(s.u * s.u + s.v * s.v)); }

}  // namespace

TEST(LobePattern, HasTheCountsOfTheSource) {
    EXPECT_EQ(circle_pattern(3, 6, true, 1.0f, 0.1f, gaussian_radius).size(), 19u);
    EXPECT_EQ(circle_pattern(3, 4, false, 1.0f, 0.1f, gaussian_radius).size(), 30u);
    EXPECT_EQ(circle_pattern(2, 4, false, 1.0f, 0.1f, gaussian_radius).size(), 14u);
    EXPECT_EQ(circle_pattern(2, 6, true, 1.0f, 0.1f, gaussian_radius).size(), 7u);
}

TEST(LobePattern, MeetsAnySmallBudgetClosely) {
    for (int n = 1; n <= 64; ++n) {
        const int found =
            static_cast<int>(regular_pattern(PatternKind::automatic, n, 0.1f, 0.1f, 0.1f, gaussian_radius).size());
        EXPECT_LE(std::abs(found - n), n <= 24 ? 2 : 5) << n;
    }
    for (const int n : {7, 14, 16, 19, 30})
        EXPECT_EQ(regular_pattern(PatternKind::automatic, n, 0.1f, 0.1f, 0, gaussian_radius).size(), size_t(n));
}

TEST(LobePattern, AreasTileTheLobe) {
    for (const float aspect : {1.0f, 0.25f, 3.0f})
        for (const float border : {0.3f, 0.1f, 0.01f})
            EXPECT_NEAR(total_area(circle_pattern(4, 6, true, aspect, border, gaussian_radius)),
                        -std::log(border) * std::numbers::pi, 1e-3);
}

TEST(LobePattern, IsSymmetricForAnyAspect) {
    for (const float aspect : {1.0f, 0.4f, 2.7f, 6.0f})
        for (const bool centred : {true, false}) {
            double u = 0, v = 0, uv = 0;
            for (const PatternSample& s : circle_pattern(4, centred ? 6 : 4, centred, aspect, 0.1f, gaussian_radius))
                u += s.u * density(s), v += s.v * density(s), uv += s.u * s.v * density(s);
            EXPECT_NEAR(u, 0, 1e-5) << aspect;
            EXPECT_NEAR(v, 0, 1e-5) << aspect;
            EXPECT_NEAR(uv, 0, 1e-5) << aspect;
        }
}

TEST(LobePattern, KeepsOnlySamplesWithinTheBorder) {
    for (const float aspect : {0.1f, 0.5f, 1.0f, 4.0f})
        for (const PatternSample& s : circle_pattern(5, 6, true, aspect, 0.1f, gaussian_radius)) EXPECT_GE(density(s), 0.0999);
}

TEST(LobePattern, FollowsTheLobesEnergyAsTheCountGrows) {
    // With equal areas the samples' densities sum to the lobe's energy within the border, 1 - xi0.
    for (const float border : {0.2f, 0.05f}) {
        double sum = 0;
        for (const PatternSample& s : circle_pattern(12, 6, true, 1.0f, border, gaussian_radius))
            sum += density(s) * s.area / std::numbers::pi;
        EXPECT_NEAR(sum, 1 - border, 5e-3);
    }
}

TEST(LobePattern, LineLiesAlongTheWiderAxis) {
    for (const PatternSample& s : line_pattern(9, 10.0f, 0.1f, gaussian_radius)) EXPECT_EQ(s.v, 0);
    for (const PatternSample& s : line_pattern(9, 0.1f, 0.1f, gaussian_radius)) EXPECT_EQ(s.u, 0);
    EXPECT_EQ(regular_pattern(PatternKind::automatic, 9, 0.4f, 0.02f, 0.1f, gaussian_radius).size(), 9u);
}

TEST(LobePattern, RingsAreDenseNearTheCentre) {
    for (const int n : {2, 5, 7, 10, 16, 19}) {
        const LobePattern rings = regular_pattern(PatternKind::rings, n, 0.1f, 0.1f, 0.1f, gaussian_radius);
        EXPECT_EQ(rings.size(), static_cast<size_t>(n));
        EXPECT_NEAR(total_area(rings), -std::log(0.1) * std::numbers::pi, 1e-3);
        double u = 0, v = 0;
        for (const PatternSample& s : rings) u += s.u * density(s), v += s.v * density(s);
        if (n > 2) {
            EXPECT_NEAR(std::hypot(u, v), 0, 1e-5) << n;
        }
    }
    const auto within_half = [](const LobePattern& pattern) {
        return std::count_if(pattern.begin(), pattern.end(),
                             [](const PatternSample& s) { return s.u * s.u + s.v * s.v < -std::log(0.1) / 4; });
    };
    EXPECT_EQ(within_half(rings_pattern(10, 0.1f, gaussian_radius)), 4) << "the centre and the first of three rings of three";
    EXPECT_EQ(within_half(regular_pattern(PatternKind::circles, 19, 0.1f, 0.1f, 0.1f, gaussian_radius)), 7);
}

TEST(LobePattern, LongTailsKeepTheEnergyOfEveryCircle) {
    // GGX: 1 / (1 + r^2) of the slopes lie beyond r; its slope density is 1 / (pi (1 + r^2)^2).
    const auto ggx_radius = [](float xi) { return std::sqrt(1 / xi - 1); };
    const LobePattern plain = circle_pattern(24, 6, true, 1.0f, 0.02f, gaussian_radius);
    const LobePattern wide = circle_pattern(24, 6, true, 1.0f, 0.02f, ggx_radius);
    double sum = 0;
    for (const PatternSample& s : wide) {
        const double r2 = s.u * s.u + s.v * s.v;
        sum += s.area / (std::numbers::pi * (1 + r2) * (1 + r2));
    }
    EXPECT_NEAR(sum, 0.98, 5e-3);
    EXPECT_GT(total_area(wide), 2 * total_area(plain));
    EXPECT_LT(wide.size(), plain.size()) << "cells of a long tail grow with the radius, so its circles need fewer samples";
}
