#include "core/scenes.h"

#include <burnish/base/error.h>
#include <burnish/surface/surfaces.h>

#include <gtest/gtest.h>

#include <limits>

using namespace burnish;

namespace {

size_t count(const Surfaces& surfaces, Validity validity) { return surfaces.counts()[static_cast<size_t>(validity)]; }

SurfaceBatch gather_all(const Surfaces& surfaces, const AovFrame& frame) {
    SurfaceBatch batch;
    surfaces.gather({0, 0, frame.data_window.width, frame.data_window.height}, 0, batch);
    return batch;
}

}  // namespace

TEST(Surfaces, SeparateTheSphereFromTheBackground) {
    const AovFrame frame = scenes::sphere_frame(64);
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const double disc = kPi / 4 * 64 * 64;
    EXPECT_NEAR(count(surfaces, Validity::valid), disc, 0.03 * disc);
    EXPECT_EQ(count(surfaces, Validity::valid) + count(surfaces, Validity::background), 64u * 64u);
}

TEST(Surfaces, CountEveryKindOfBadPixel) {
    AovFrame frame = scenes::sphere_frame(64);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Image &p = frame.layers[Role::position], &n = frame.layers[Role::normal];
    p.at(30, 30)[0] = nan;
    p.at(31, 30)[1] = inf;
    p.at(32, 30)[2] = 1e10f;
    n.at(33, 30)[2] = nan;
    std::fill_n(n.at(34, 30), 3, 0.0f);
    for (int c = 0; c < 3; ++c) n.at(35, 30)[c] *= 0.2f;
    for (int c = 0; c < 3; ++c) n.at(36, 30)[c] *= 0.5f;
    for (int c = 0; c < 3; ++c) n.at(37, 30)[c] *= -1.0f;
    Assignment assignment = scenes::whole_frame(frame);
    assignment.rule[30 * 64 + 38] = -1;
    const AovFrame clean = scenes::sphere_frame(64);
    const Assignment whole = scenes::whole_frame(clean);
    const size_t background = count(Surfaces(clean, whole, {}), Validity::background);
    const Surfaces surfaces(frame, assignment, {});
    EXPECT_EQ(count(surfaces, Validity::not_finite), 2u);
    EXPECT_EQ(count(surfaces, Validity::background), background + 2);
    EXPECT_EQ(count(surfaces, Validity::zero_normal), 1u);
    EXPECT_EQ(count(surfaces, Validity::averaged_normal), 1u);
    EXPECT_EQ(count(surfaces, Validity::back_facing), 1u);
    EXPECT_EQ(count(surfaces, Validity::unassigned), 1u);
    EXPECT_EQ(surfaces.validity(30 * 64 + 36), Validity::valid) << "a normal of length 0.5 is renormalised, not dropped";
}

TEST(Surfaces, BatchesHoldUnitVectorsThatFaceTheCamera) {
    const AovFrame frame = scenes::sphere_frame(48);
    const Assignment assignment = scenes::whole_frame(frame);
    const SurfaceBatch batch = gather_all(Surfaces(frame, assignment, {}), frame);
    ASSERT_GT(batch.size(), 1000u);
    for (size_t i = 0; i < batch.size(); ++i) {
        EXPECT_NEAR(batch.n[i].length(), 1, 1e-5);
        EXPECT_NEAR(batch.wo[i].length(), 1, 1e-5);
        EXPECT_NEAR(batch.t[i].dot(batch.n[i]), 0, 1e-5);
        EXPECT_GT(batch.n[i].dot(batch.wo[i]), 0);
    }
    EXPECT_TRUE(batch.ng.x.empty());
}

TEST(Surfaces, BatchesHoldWhatIsAskedForOnly) {
    AovFrame frame = scenes::sphere_frame(16);
    frame.layers[Role::geometric_normal] = frame.layers.at(Role::normal);
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    EXPECT_EQ(surfaces.rule_counts(), std::vector<size_t>{count(surfaces, Validity::valid)});
    SurfaceBatch batch;
    surfaces.gather({0, 0, 16, 16}, 0, batch, {.position = false, .tangent = false});
    EXPECT_EQ(batch.size(), count(surfaces, Validity::valid));
    EXPECT_TRUE(batch.p.x.empty());
    EXPECT_TRUE(batch.t.x.empty());
    ASSERT_EQ(batch.ng.x.size(), batch.size());
    for (size_t i = 0; i < batch.size(); ++i) EXPECT_NEAR((batch.ng[i] - batch.n[i]).length(), 0, 1e-6);
}

TEST(Surfaces, TangentsFromUvsFollowTheDirectionOfGrowingU) {
    AovFrame frame = scenes::sphere_frame(96);
    Image uv(96, 96, 2);
    const Image& p = frame.layers[Role::position];
    for (size_t i = 0; i < uv.pixel_count(); ++i) {
        const float* v = p.at(i);
        uv.at(i)[0] = std::atan2(v[0], v[2]) / (2 * kPi) + 0.5f, uv.at(i)[1] = std::asin(std::clamp(v[1], -1.0f, 1.0f)) / kPi;
    }
    frame.layers[Role::uv] = uv;
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    EXPECT_EQ(surfaces.tangent_source(), TangentSource::uv);
    const SurfaceBatch batch = gather_all(surfaces, frame);
    size_t close = 0;
    for (size_t i = 0; i < batch.size(); ++i) close += batch.t[i].dot(Vec3f(0, 1, 0).cross(batch.n[i]).normalized()) > 0.99f;
    EXPECT_GT(close, batch.size() * 97 / 100);
}

TEST(Surfaces, RoughnessIsSquaredUnlessTheLayerHoldsAlpha) {
    AovFrame frame = scenes::sphere_frame(16);
    frame.layers[Role::roughness] = Image(16, 16, 1, 0.5f);
    const Assignment assignment = scenes::whole_frame(frame);
    EXPECT_FLOAT_EQ(gather_all(Surfaces(frame, assignment, {}), frame).roughness.at(0), 0.25f);
    SurfaceSettings as_alpha;
    as_alpha.roughness_is_alpha = true;
    EXPECT_FLOAT_EQ(gather_all(Surfaces(frame, assignment, as_alpha), frame).roughness.at(0), 0.5f);
}

TEST(Surfaces, AskForACameraWhenThereIsNone) {
    AovFrame frame = scenes::sphere_frame(8);
    frame.camera.reset();
    const Assignment assignment = scenes::whole_frame(frame);
    EXPECT_THROW(Surfaces(frame, assignment, {}), Error);
}
