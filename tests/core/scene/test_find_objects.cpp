// Objects by name, and their largest sides.
#include <burnish/scene/demo_room.h>
#include <burnish/scene/find_objects.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(FindObjects, PatternsNameObjectsInTheScenesOrder) {
    const Scene room = make_demo_room();
    const std::vector<int> balls = objects_named(room, "ball_*"), two = objects_named(room, "ring_rubber, floor_dark");
    ASSERT_EQ(balls.size(), 3u);
    for (const int i : balls) EXPECT_TRUE(room.objects[static_cast<size_t>(i)].name.starts_with("ball_"));
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(room.objects[static_cast<size_t>(two[0])].name, "floor_dark");
    EXPECT_TRUE(objects_named(room, "Ball_*").empty());
    EXPECT_TRUE(objects_named(room, "").empty());
}

TEST(FindObjects, TheMiddleIsThatOfTheBoxAroundAll) {
    const Scene room = make_demo_room();
    const Vec3f middle = bounding_centre(room, objects_named(room, "floor_*"));
    EXPECT_NEAR((middle - Vec3f(0, 0.25f, 0)).length(), 0, 1e-5);
}

TEST(FindObjects, TheLargestPlaneIsTheSideThatTheEyeSees) {
    const Scene room = make_demo_room();
    const std::vector<int> table = objects_named(room, "table_top");
    const auto top = largest_plane(room, table, {0, -2, 1.5f}), under = largest_plane(room, table, {0, -2, 0.1f});
    ASSERT_TRUE(top && under);
    EXPECT_NEAR(top->normal.z, 1, 1e-6);
    EXPECT_NEAR(top->point.z, 0.72f, 1e-5);
    EXPECT_NEAR(under->normal.z, -1, 1e-6);
    EXPECT_NEAR(under->point.z, 0.68f, 1e-5);
    EXPECT_FALSE(largest_plane(room, objects_named(room, "ceiling"), {0, 0, 5}));
}

}  // namespace
}  // namespace burnish
