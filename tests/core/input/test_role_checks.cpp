// The numbers behind "this layer is what it says", on layers of known content.
#include <burnish/input/role_checks.h>

#include <core/input/synthetic_frame.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

Image encoded(const Image& normal) {
    return SyntheticFrame::mapped(normal, [](const Vec3f& n) { return (n + Vec3f(1.0f)) * 0.5f; });
}

TEST(RoleChecks, KnowUnitNormals) {
    const VectorCheck check = check_vectors(scene().normal);
    EXPECT_EQ(check.kind, VectorKind::unit);
    EXPECT_NEAR(check.median_length, 1.0f, 1e-5f);
}

TEST(RoleChecks, KnowEncodedNormalsAndDecodeThem) {
    Image layer = encoded(scene().normal);
    EXPECT_EQ(check_vectors(layer).kind, VectorKind::encoded);
    decode_vectors(layer);
    for (size_t i = 0; i < layer.data.size(); ++i) EXPECT_NEAR(layer.data[i], scene().normal.data[i], 1e-6f);
}

TEST(RoleChecks, KnowNormalsEncodedInEightBits) {
    Image layer = encoded(scene().normal);
    for (float& value : layer.data) value = std::round(255 * value) / 255;
    EXPECT_EQ(check_vectors(layer).kind, VectorKind::encoded);
}

TEST(RoleChecks, DoNotTakeUnitNormalsInTheFirstOctantForEncodedOnes) {
    const Image layer = SyntheticFrame::mapped(
        scene().normal, [](const Vec3f& n) { return Vec3f(std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)); });
    EXPECT_EQ(check_vectors(layer).kind, VectorKind::unit);
}

TEST(RoleChecks, RefuseColourAsNormals) {
    Image colour(64, 64, 3);
    uint32_t state = 1;
    for (float& value : colour.data) value = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / (1 << 24);
    EXPECT_EQ(check_vectors(colour).kind, VectorKind::neither);
}

TEST(RoleChecks, IgnoreBackgroundAndNaN) {
    Image layer = scene().normal;
    for (size_t i = 0; i < layer.pixel_count(); ++i)
        if (i % 3) std::fill_n(layer.at(i), 3, i % 3 == 1 ? 0.0f : kNaN);
    EXPECT_EQ(check_vectors(layer).kind, VectorKind::unit);
    EXPECT_EQ(check_vectors(Image(8, 8, 3)).kind, VectorKind::empty);
    EXPECT_EQ(check_vectors(Image(8, 8, 3, kInfinity)).kind, VectorKind::empty);
}

TEST(RoleChecks, MeasureWhatFacesTheCamera) {
    const Image flipped = SyntheticFrame::mapped(scene().normal, [](const Vec3f& n) { return -n; });
    const Vec3f eye = scene().camera.centre;
    EXPECT_EQ(facing_share(scene().normal, scene().position, eye).share, 1.0);
    EXPECT_EQ(facing_share(flipped, scene().position, eye).share, 0.0);
    EXPECT_LT(facing_share(scene().in_camera_space(scene().normal), scene().position, eye).share, 0.9);
}

TEST(RoleChecks, MeasureHowFarPositionsAre) {
    EXPECT_EQ(check_positions(Image(8, 8, 3)).pixels, 0u);
    EXPECT_EQ(check_positions(Image(8, 8, 3, 1e10f)).pixels, 0u);
    Image position(3, 1, 3);
    position.data = {0, 0, 0, 1, -5, 2, kNaN, 1, 1};
    EXPECT_EQ(check_positions(position).pixels, 1u);
    EXPECT_EQ(check_positions(position).median_size, 5.0f);
}

TEST(RoleChecks, KnowTheStepsOfHalfFloats) {
    EXPECT_EQ(half_step(10.0f), 0.0078125f);
    EXPECT_EQ(half_step(100.0f), 0.0625f);
    EXPECT_EQ(half_step(1000.0f), 0.5f);
    EXPECT_GT(half_step(0.0f), 0.0f);
}

TEST(RoleChecks, ScrubCountsPixelsNotValues) {
    Image image(3, 1, 3, 1.0f);
    image.at(1, 0)[0] = kNaN, image.at(1, 0)[2] = -kInfinity;
    EXPECT_EQ(scrub(image), 1u);
    EXPECT_EQ(image.data, (PixelVector<float>{1, 1, 1, 0, 1, 0, 1, 1, 1}));
}

}  // namespace
}  // namespace burnish
