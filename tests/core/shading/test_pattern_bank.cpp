// Patterns chosen by lobe: of the lobe's own widths, and with layers of nearly those at every pixel's.
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/pattern_bank.h>

#include <gtest/gtest.h>

using namespace burnish;

namespace {

EstimatorSettings seven_samples() {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::regular, settings.samples = 7;
    return settings;
}

/// Largest difference in place of two patterns of one arrangement.
float farthest(const LobePattern& a, const LobePattern& b) {
    EXPECT_EQ(a.size(), b.size());
    float distance = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        distance = std::max(distance, std::hypot(a[i].u - b[i].u, a[i].v - b[i].v));
    return distance;
}

}  // namespace

TEST(PatternBank, FollowsTheWidthOfEachPixel) {
    LobeParameters lobe;
    lobe.mx = lobe.my = 0.1f;
    lobe.per_pixel.roughness = true;
    const PatternBank bank(lobe, seven_samples());
    for (float m = 0.005f; m < 1; m *= 1.07f)
        EXPECT_LT(farthest(bank.at(m, m), tuned_pattern(7, m, m, LobeTail::gaussian)), 0.03f) << m;
    EXPECT_GT(farthest(bank.at(0.02f, 0.02f), bank.at(0.4f, 0.4f)), 0.1f) << "the table does tell the widths apart";
}

TEST(PatternBank, TakesTheLobesOwnWidthsWithoutLayers) {
    LobeParameters lobe;
    lobe.mx = lobe.my = 0.3f;
    const PatternBank bank(lobe, seven_samples());
    EXPECT_EQ(farthest(bank.at(0.02f, 0.02f), tuned_pattern(7, 0.3f, 0.3f, LobeTail::gaussian)), 0);
}

TEST(PatternBank, TurnsWithTheAnisotropyOfEachPixel) {
    LobeParameters lobe;
    lobe.mx = lobe.my = 0.1f;
    lobe.per_pixel.anisotropy = true;
    const PatternBank bank(lobe, seven_samples());
    const LobePattern &wide = bank.at(0.13f, 0.1f), &tall = bank.at(0.1f, 0.13f);
    ASSERT_EQ(wide.size(), tall.size());
    for (size_t i = 0; i < wide.size(); ++i) EXPECT_EQ(Vec2f(wide[i].u, wide[i].v), Vec2f(tall[i].v, tall[i].u));
}
