// Renderer-like EXRs: what is written is what the reader finds, ids to the bit.
#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/input/cryptomatte.h>
#include <burnish/input/exr_reader.h>
#include <burnish/output/aov_writer.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/object_matte.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace burnish {
namespace {

/// A ball on a floor, with ids, matte and a beauty whose values half floats hold exactly.
AovFrame traced_frame() {
    Matrix44f lift;
    lift.setTranslation(Vec3f(0, 0, 1));
    Scene scene;
    scene.objects.push_back({"floor", "", make_plane(4, 4), 3, 1, Color3f(0.5f), 0.25f});
    scene.objects.push_back({"ball \"A\"", "", transformed(make_sphere(1, 64), lift), 7, 2, Color3f(0.5f), 0.75f});
    Camera camera;
    camera.centre = {0, -6, 2}, camera.axis = Vec3f(0, 1, -0.2f).normalized(), camera.right = {0.6f, 0, 0};
    camera.up = camera.right.cross(camera.axis) * 0.5f, camera.has_rays = true;
    const Tracer tracer(scene);
    AovFrame frame = trace_gbuffer(tracer, camera, 64, 32, {});
    frame.cryptomattes.push_back(trace_object_matte(tracer, camera, 64, 32, 4, 3, "CryptoObject", {}));
    frame.layers[Role::beauty] = Image(64, 32, 3, 0.375f);
    frame.layers[Role::alpha] = Image(64, 32, 1, 1.0f);
    return frame;
}

AovFrame read_back(const std::string& file) {
    ReadOptions options;
    options.cryptomattes = true;
    return read_frame(file, options);
}

std::string bytes_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(AovWriter, TheCameraInTheHeaderIsTheFrames) {
    const Scratch scratch;
    const AovFrame written = traced_frame();
    write_aovs(scratch.file("shot.exr"), written, "ViewLayer");
    const AovFrame frame = read_back(scratch.file("shot.exr"));
    ASSERT_TRUE(frame.camera);
    EXPECT_EQ(frame.camera->source, "header");
    EXPECT_NEAR((frame.camera->centre - written.camera->centre).length(), 0, 1e-4);
    EXPECT_NEAR((frame.camera->axis - written.camera->axis).length(), 0, 1e-4);
    EXPECT_NEAR((frame.camera->right - written.camera->right).length(), 0, 1e-4);
    EXPECT_NEAR((frame.camera->up - written.camera->up).length(), 0, 1e-4);
}

TEST(AovWriter, EveryLayerIsReadBackToTheBit) {
    const Scratch scratch;
    const AovFrame written = traced_frame();
    write_aovs(scratch.file("shot.exr"), written, "ViewLayer");
    const AovFrame frame = read_back(scratch.file("shot.exr"));
    EXPECT_EQ(frame.data_window, written.data_window);
    for (const auto& [role, image] : written.layers) {
        ASSERT_TRUE(frame.has(role)) << role_info(role).name;
        ASSERT_EQ(frame.layer(role).data.size(), image.data.size()) << role_info(role).name;
        EXPECT_EQ(std::memcmp(frame.layer(role).data.data(), image.data.data(), image.data.size() * sizeof(float)), 0)
            << role_info(role).name;
    }
}

TEST(AovWriter, MattesKeepTheirIdsAndManifest) {
    const Scratch scratch;
    const AovFrame written = traced_frame();
    write_aovs(scratch.file("shot.exr"), written, "ViewLayer");
    const AovFrame frame = read_back(scratch.file("shot.exr"));
    ASSERT_EQ(frame.cryptomattes.size(), 1u);
    const Cryptomatte &matte = frame.cryptomattes[0], &expected = written.cryptomattes[0];
    EXPECT_EQ(matte.name, "ViewLayer.CryptoObject");
    EXPECT_EQ(matte.manifest, expected.manifest);
    ASSERT_EQ(matte.ranks.size(), 4u);  // three were written; two share a layer
    for (const float value : matte.ranks[3].data) ASSERT_EQ(value, 0);
    for (size_t rank = 0; rank < expected.ranks.size(); ++rank)
        EXPECT_EQ(std::memcmp(matte.ranks[rank].data.data(), expected.ranks[rank].data.data(),
                              expected.ranks[rank].data.size() * sizeof(float)),
                  0);
    const Image coverage = cryptomatte_coverage(matte, matching_ids(matte, "ball*"));
    EXPECT_GT(std::count(coverage.data.begin(), coverage.data.end(), 1.0f), 100);
}

TEST(AovWriter, TheSameFrameGivesTheSameBytes) {
    const Scratch scratch;
    const AovFrame frame = traced_frame();
    write_aovs(scratch.file("a.exr"), frame, "ViewLayer");
    write_aovs(scratch.file("b.exr"), frame, "ViewLayer");
    EXPECT_EQ(bytes_of(scratch.file("a.exr")), bytes_of(scratch.file("b.exr")));
}

TEST(AovWriter, LeavesNothingWhereItCannotWrite) {
    const Scratch scratch;
    std::ofstream(scratch.file("taken")) << "a file, not a folder";
    EXPECT_THROW(write_aovs(scratch.file("taken") + "/shot.exr", traced_frame(), "ViewLayer"), Error);
    EXPECT_EQ(scratch.file_count(), 1u);
}

}  // namespace
}  // namespace burnish
