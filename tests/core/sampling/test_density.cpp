// When shading is sparse without being asked.
#include <burnish/sampling/density.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr size_t kSmall = 640 * 360, kFullHd = 1920 * 1080;

ShadingDensity settled(EstimatorKind kind, int samples, size_t pixels, bool is_near = false) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples;
    return settled_density(ShadingDensity::automatic, settings, pixels, is_near);
}

TEST(Density, IsSparseWhereThatPays) {
    EXPECT_EQ(settled(EstimatorKind::fitted, 0, kSmall), ShadingDensity::dense);
    EXPECT_EQ(settled(EstimatorKind::fitted, 0, kFullHd), ShadingDensity::sparse);
    EXPECT_EQ(settled(EstimatorKind::fitted, 0, kSmall, true), ShadingDensity::sparse);
    EXPECT_EQ(settled(EstimatorKind::filtered_importance, 64, kSmall), ShadingDensity::sparse);
}

TEST(Density, OfTheReferenceIsDense) { EXPECT_EQ(settled(EstimatorKind::reference, 0, kFullHd, true), ShadingDensity::dense); }

TEST(Density, IsWhatWasAskedFor) {
    for (const ShadingDensity asked : {ShadingDensity::dense, ShadingDensity::sparse})
        EXPECT_EQ(settled_density(asked, {}, kSmall, false), asked);
}

}  // namespace
}  // namespace burnish
