// Mirrored renders from files, and the cameras that saw them.
#include "box_room.h"
#include "core/data.h"
#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/output/aov_writer.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

/// The buffer of a file with what `camera` sees of the room: its settings name no camera.
MirrorBuffer from_file(const BoxRoom& room, const Camera& camera, std::vector<Role> without,
                       const std::optional<Camera>& frame_camera) {
    AovFrame frame = room.render(camera, 160, 90);
    Image depth(160, 90, 1);
    for (size_t i = 0; i < depth.pixel_count(); ++i) {
        const float* p = frame.layers[Role::position].at(i);
        *depth.at(i) = (Vec3f(p[0], p[1], p[2]) - camera.centre).dot(camera.forward());
    }
    frame.layers[Role::depth] = std::move(depth);
    for (const Role role : without) frame.layers.erase(role);
    const Scratch scratch;
    MirrorSettings settings = floor_mirror();
    settings.file = scratch.file("mirror.exr");
    write_aovs(settings.file, frame, "ViewLayer");
    return MirrorBuffer::load(settings, frame_camera);
}

void expect_same(const Camera& found, const Camera& truth, float tolerance) {
    EXPECT_LT((found.centre - truth.centre).length(), tolerance);
    EXPECT_LT((found.axis / found.axis.length() - truth.axis / truth.axis.length()).length(), tolerance);
    EXPECT_LT((found.right / found.axis.length() - truth.right / truth.axis.length()).length(), tolerance);
    EXPECT_LT((found.up / found.axis.length() - truth.up / truth.axis.length()).length(), tolerance);
}

}  // namespace

TEST(MirrorBuffer, MirrorsCamerasLeftForRight) {
    const Camera camera = room_camera(), image = mirrored(camera, floor_mirror().plane);
    const Vec3f p(0.3f, 1, 0.8f);
    const Vec2f seen = *image.project(p), in_mirror = *camera.project({p.x, p.y, -p.z});
    EXPECT_NEAR(seen.x, -in_mirror.x, 1e-5f);
    EXPECT_NEAR(seen.y, in_mirror.y, 1e-5f);
    EXPECT_GT(image.right.cross(image.up).dot(image.axis) * camera.right.cross(camera.up).dot(camera.axis), 0)
        << "can be built";
}

TEST(MirrorBuffer, RecoversItsCameraFromPlaces) {
    const Camera truth = mirrored(room_camera(), floor_mirror().plane);
    expect_same(from_file(furnished_room(), truth, {}, std::nullopt).camera, truth, 1e-4f);
}

TEST(MirrorBuffer, TakesTheFramesCameraWhereThePlacesTellNone) {
    // A flat wall has no camera of its own; the picture may be turned any way about its axis.
    Camera camera = room_camera();
    camera.centre = {0, 2, 1.5f}, camera.right *= 0.25f, camera.up *= 0.25f;
    for (const Vec2f& sign : {Vec2f(1, 1), Vec2f(-1, 1), Vec2f(1, -1), Vec2f(-1, -1)}) {
        Camera truth = mirrored(camera, floor_mirror().plane);
        truth.right *= sign.x, truth.up *= sign.y;
        expect_same(from_file(BoxRoom({}), truth, {}, camera).camera, truth, 1e-4f);
    }
}

TEST(MirrorBuffer, MakesPlacesFromDepth) {
    const Camera truth = mirrored(room_camera(), floor_mirror().plane);
    const MirrorBuffer made = from_file(furnished_room(), truth, {Role::position}, room_camera());
    const MirrorBuffer given = from_file(furnished_room(), truth, {}, room_camera());
    for (size_t i = 0; i < made.position.pixel_count(); ++i)
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(made.position.at(i)[k], given.position.at(i)[k], 1e-3f);
}

TEST(MirrorBuffer, SaysWhatIsMissing) {
    const Camera truth = mirrored(room_camera(), floor_mirror().plane);
    EXPECT_THROW(from_file(furnished_room(), truth, {Role::normal}, room_camera()), Error);
    EXPECT_THROW(from_file(furnished_room(), truth, {Role::position}, std::nullopt), Error);
}

TEST(MirrorBuffer, KnowsItsPlaneWhateverTheScale) {
    for (const float scale : {1e-3f, 1.0f, 1e3f}) {
        const Plane floor{Vec3f(1, 2, 0) * scale, Vec3f(0, 0, -3)};
        EXPECT_TRUE(lies_on(floor, Vec3f(4, -3, 0.002f) * scale, {0, 0, 1}));
        EXPECT_TRUE(lies_on(floor, Vec3f(4, -3, 0) * scale, Vec3f(0.3f, 0.2f, 0.9f).normalized()));
        EXPECT_FALSE(lies_on(floor, Vec3f(4, -3, 0.02f) * scale, {0, 0, 1}));
        EXPECT_FALSE(lies_on(floor, Vec3f(4, -3, 0) * scale, {1, 0, 0})) << "a box that stands on it";
    }
}

TEST(MirrorBuffer, ReadsTheOneOfCycles) {
    const auto folder = data_path("cycles/room");
    if (!folder) GTEST_SKIP() << "no data";
    MirrorSettings settings = floor_mirror();
    settings.file = *folder / "mirror.exr";
    const MirrorBuffer recovered = MirrorBuffer::load(settings, std::nullopt);
    settings.camera = *folder / "mirror.json";
    const MirrorBuffer given = MirrorBuffer::load(settings, std::nullopt);
    expect_same(recovered.camera, given.camera, 1e-4f);
}
