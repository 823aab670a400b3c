#include "core/data.h"
#include "core/input/synthetic_view.h"
#include "core/read_layer.h"

#include <burnish/base/error.h>
#include <burnish/input/camera_json.h>
#include <burnish/input/depth.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace burnish;

namespace {

const Window kData{-10, 5, 200, 120}, kDisplay{0, 0, 320, 180};
const Camera kCamera = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f, 0.3f, 0.1f);

/// Depth of each position; 1e10 where nothing was hit.
Image depth_layer(const Image& position, bool ray_distance) {
    Image depth(position.width, position.height, 1, 1e10f);
    for (size_t i = 0; i < position.pixel_count(); ++i) {
        const float* p = position.at(i);
        if (p[0] == 0 && p[1] == 0 && p[2] == 0) continue;
        const Vec3f d = Vec3f(p[0], p[1], p[2]) - kCamera.centre;
        *depth.at(i) = ray_distance ? d.length() : kCamera.forward().dot(d);
    }
    return depth;
}

struct Render {
    Camera camera;
    Window window;
    Image depth;
};

Render read_render(const std::string& stem) {
    Render render;
    render.depth = read_layer(stem + ".exr", {"ViewLayer.Depth.Z"});
    render.window = {0, 0, render.depth.width, render.depth.height};
    render.camera = camera_from_json(nlohmann::json::parse(std::ifstream(stem + ".json"))["camera"], stem,
                                     static_cast<float>(render.window.width) / render.window.height);
    return render;
}

}  // namespace

TEST(Depth, GivesPositionsBack) {
    const Image position = position_layer(kCamera, kData, kDisplay, SyntheticScene::ball_only);
    for (const bool ray_distance : {false, true}) {
        const Image found = position_from_depth(depth_layer(position, ray_distance), kCamera, kData, kDisplay, ray_distance);
        for (size_t i = 0; i < position.pixel_count(); ++i) {
            const float *p = position.at(i), *q = found.at(i);
            if (p[0] == 0 && p[1] == 0 && p[2] == 0)
                EXPECT_TRUE(std::isnan(q[0]) && std::isnan(q[1]) && std::isnan(q[2]));
            else
                EXPECT_LT((Vec3f(p[0], p[1], p[2]) - Vec3f(q[0], q[1], q[2])).length(), 1e-5f);
        }
    }
}

TEST(Depth, MarksEveryKindOfMiss) {
    Image depth(5, 1, 1);
    depth.data = {NAN, INFINITY, 1e10f, 0, -1};
    for (float value : position_from_depth(depth, kCamera, Window{0, 0, 5, 1}, {0, 0, 5, 1}, false).data)
        EXPECT_TRUE(std::isnan(value));
}

TEST(Depth, NeedsRays) {
    Camera centre_only;
    EXPECT_THROW(position_from_depth(Image(2, 2, 1, 1.0f), centre_only, Window{0, 0, 2, 2}, {0, 0, 2, 2}, false), Error);
}

TEST(Depth, IsToldByItsPositions) {
    const Image position = position_layer(kCamera, kData, kDisplay, SyntheticScene::room_with_ball);
    Image scaled = depth_layer(position, false);
    for (float& z : scaled.data) z /= 100;
    EXPECT_EQ(depth_kind(depth_layer(position, false), position, kCamera, kData, kDisplay), DepthKind::planar);
    EXPECT_EQ(depth_kind(depth_layer(position, true), position, kCamera, kData, kDisplay), DepthKind::ray_distance);
    EXPECT_EQ(depth_kind(scaled, position, kCamera, kData, kDisplay), DepthKind::neither);
}

TEST(Depth, OfCyclesGivesThePositionsOfCycles) {
    if (!data_path("cycles/spheres/spheres.exr")) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    for (const char* name : {"cycles/spheres/spheres", "cycles/room/room"}) {
        const std::string stem = data_path(std::string(name) + ".exr")->replace_extension().string();
        const Render render = read_render(stem);
        const Image position =
            read_layer(stem + ".exr", {"ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z"});
        EXPECT_EQ(depth_kind(render.depth, position, render.camera, render.window, render.window), DepthKind::planar);
        const Image found = position_from_depth(render.depth, render.camera, render.window, render.window, false);
        double largest = 0;
        for (size_t i = 0; i < position.pixel_count(); ++i) {
            if (!(*render.depth.at(i) < 1e9f)) continue;
            const float *p = position.at(i), *q = found.at(i);
            largest = std::max<double>(largest, (Vec3f(p[0], p[1], p[2]) - Vec3f(q[0], q[1], q[2])).length());
        }
        EXPECT_LT(largest, 5e-5) << name;
    }
}

TEST(Depth, GivesTheSameStillBallsInEveryFrameOfAMovingCamera) {
    if (!data_path("cycles/anim")) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    // Two frames see the same ball from two places: its points must lie on one sphere.
    std::vector<Imath::V3d> points;
    for (const char* name : {"anim_0001", "anim_0008"}) {
        const std::string stem = data_path("cycles/anim")->string() + "/" + name;
        const Render render = read_render(stem);
        const Image index = read_layer(stem + ".exr", {"ViewLayer.IndexMA.X"});
        const Image position = position_from_depth(render.depth, render.camera, render.window, render.window, false);
        for (size_t i = 0; i < index.pixel_count(); ++i)
            if (*index.at(i) == 1) points.push_back({position.at(i)[0], position.at(i)[1], position.at(i)[2]});
    }
    ASSERT_GT(points.size(), 500u);
    // |p|^2 = 2 p.c + (r^2 - |c|^2) is linear in c: four unknowns by normal equations.
    Imath::M44d normal(0.0);
    double rhs[4] = {};
    for (const Imath::V3d& p : points) {
        const double row[4] = {2 * p.x, 2 * p.y, 2 * p.z, 1};
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) normal[i][j] += row[i] * row[j];
            rhs[i] += row[i] * p.dot(p);
        }
    }
    const Imath::M44d inverse = normal.inverse();
    double c[4] = {};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) c[i] += inverse[i][j] * rhs[j];
    const Imath::V3d centre(c[0], c[1], c[2]);
    const double radius = std::sqrt(c[3] + centre.dot(centre));
    double largest = 0;
    for (const Imath::V3d& p : points) largest = std::max(largest, std::fabs((p - centre).length() - radius));
    EXPECT_LT(largest, 2e-3 * radius) << "radius " << radius;
}
