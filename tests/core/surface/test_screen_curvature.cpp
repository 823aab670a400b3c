// Curvature from the screen: right on a sphere, whatever noise, half floats and bump maps do to it, and blind to edges.
#include "core/scenes.h"

#include <burnish/surface/screen_curvature.h>

#include <Imath/half.h>
#include <gtest/gtest.h>

#include <functional>

using namespace burnish;

namespace {

/// Curvatures of the pixels that `wanted` picks (all valid ones by default), in order.
std::vector<float> curvatures(const AovFrame& frame, const std::function<bool(int x, int y)>& wanted = {}) {
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const Image image = screen_curvature(ScreenCurvature(frame, assignment, surfaces), assignment.width, assignment.height);
    std::vector<float> list;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float c = *image.at(x, y);
            EXPECT_TRUE(std::isfinite(c) && c >= 0);
            const bool is_valid = surfaces.validity(static_cast<size_t>(y) * image.width + x) == Validity::valid;
            if (is_valid && (!wanted || wanted(x, y))) list.push_back(c);
        }
    std::sort(list.begin(), list.end());
    return list;
}

float quantile(const std::vector<float>& sorted, double share) {
    return sorted.at(static_cast<size_t>(share * static_cast<double>(sorted.size() - 1)));
}

void to_halves(Image& image) {
    for (float& value : image.data) value = Imath::half(value);
}

/// Moves frame and camera.
void move(AovFrame& frame, const Vec3f& by) {
    Image& position = frame.layers[Role::position];
    for (size_t i = 0; i < position.pixel_count(); ++i) {
        float* p = position.at(i);
        if (p[0] == 0 && p[1] == 0 && p[2] == 0) continue;
        p[0] += by.x, p[1] += by.y, p[2] += by.z;
    }
    frame.camera->centre += by;
}

/// Changes the normals of a frame's surface; `change(normal, x, y)` need not keep them unit.
void change_normals(AovFrame& frame, const std::function<Vec3f(Vec3f n, int x, int y)>& change) {
    Image& normal = frame.layers[Role::normal];
    for (int y = 0; y < normal.height; ++y)
        for (int x = 0; x < normal.width; ++x) {
            float* v = normal.at(x, y);
            if (v[0] == 0 && v[1] == 0 && v[2] == 0) continue;
            const Vec3f n = change({v[0], v[1], v[2]}, x, y).normalized();
            std::copy_n(&n.x, 3, v);
        }
}

/// A roof over y = 0 seen from (0, 0, 6): two planes that meet at x = 0, each falling by `slope`.
AovFrame roof_frame(int size, float slope) {
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, size, size};
    Image position(size, size, 3), normal(size, size, 3);
    Camera camera;
    camera.centre = Vec3f(0, 0, 6), camera.right = Vec3f(0.2f, 0, 0), camera.up = Vec3f(0, 0.2f, 0), camera.has_rays = true;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3f d = camera.ray({2 * (x + 0.5f) / size - 1, 1 - 2 * (y + 0.5f) / size});
            const float side = d.x < 0 ? -1.0f : 1.0f;
            const Vec3f n = Vec3f(side * slope, 0, 1).normalized(), p = camera.centre + d * (-camera.centre.dot(n) / d.dot(n));
            std::copy_n(&p.x, 3, position.at(x, y)), std::copy_n(&n.x, 3, normal.at(x, y));
        }
    frame.layers[Role::position] = std::move(position), frame.layers[Role::normal] = std::move(normal);
    frame.camera = camera;
    return frame;
}

}  // namespace

TEST(ScreenCurvature, ASpheresIsOneOverItsRadius) {
    for (const bool has_rays : {true, false}) {
        AovFrame frame = scenes::sphere_frame(240);
        frame.camera->has_rays = has_rays;
        const std::vector<float> c = curvatures(frame);
        EXPECT_NEAR(quantile(c, 0.5), 1, 0.03) << has_rays;
        EXPECT_GT(quantile(c, 0.05), 0.8) << has_rays;
        EXPECT_LT(quantile(c, 0.95), 1.2) << has_rays;
    }
}

TEST(ScreenCurvature, APlanesIsNoneAndARoofsRidgeIsSharp) {
    const std::vector<float> plane = curvatures(roof_frame(64, 0));
    EXPECT_EQ(plane.back(), 0);
    const AovFrame roof = roof_frame(64, 0.5f);
    EXPECT_EQ(curvatures(roof, [](int x, int) { return x < 30 || x > 33; }).back(), 0);
    const float step = 0.4f / 64 * 6, turn = 2 * std::atan(0.5f);
    EXPECT_GT(curvatures(roof, [](int x, int) { return x == 31 || x == 32; }).front(), 0.3f * turn / step);
}

TEST(ScreenCurvature, EdgesOfObjectsAndOfDepthAreNoCurvature) {
    AovFrame apart = roof_frame(64, 0.5f);
    Image ids(64, 64, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 32; x < 64; ++x) *ids.at(x, y) = 1;
    apart.layers[Role::object_id] = ids;
    EXPECT_EQ(curvatures(apart).back(), 0);

    AovFrame step = roof_frame(64, 0);
    change_normals(step, [](const Vec3f& n, int x, int) { return x < 32 ? n : n + Vec3f(0.3f, 0, 0); });
    Image& position = step.layers[Role::position];
    for (int y = 0; y < 64; ++y)
        for (int x = 32; x < 64; ++x) {
            float* p = position.at(x, y);
            const Vec3f moved = step.camera->centre + (Vec3f(p[0], p[1], p[2]) - step.camera->centre) * 0.8f;
            std::copy_n(&moved.x, 3, p);
        }
    EXPECT_LT(curvatures(step).back(), 1e-3);
}

TEST(ScreenCurvature, NoiseOfNormalsAndHalfFloatsHardlyMoveIt) {
    for (const int size : {120, 400}) {
        AovFrame noisy = scenes::sphere_frame(size);
        std::mt19937 random(5);
        std::normal_distribution<float> noise(0, 1.0f / size);  // half of what a pixel turns the normal by
        change_normals(noisy, [&](const Vec3f& n, int, int) { return n + Vec3f(noise(random), noise(random), noise(random)); });
        const float median = quantile(curvatures(noisy), 0.5);
        EXPECT_GT(median, 0.5) << size;
        EXPECT_LT(median, 2) << size;

        AovFrame halves = scenes::sphere_frame(size);
        to_halves(halves.layers[Role::normal]), to_halves(halves.layers[Role::position]);
        EXPECT_NEAR(quantile(curvatures(halves), 0.5), 1, 0.1) << size;
    }
}

TEST(ScreenCurvature, PositionsInHalvesFarFromTheOriginDoNotExplode) {
    for (const bool has_rays : {true, false}) {
        AovFrame frame = scenes::sphere_frame(200);
        frame.camera->has_rays = has_rays;
        move(frame, {300, 100, -700});
        to_halves(frame.layers[Role::position]);  // steps of 1/2, 1/16, 1/4: as large as the sphere
        const std::vector<float> c = curvatures(frame);
        ASSERT_GT(c.size(), 10000u);
        EXPECT_LT(quantile(c, 0.99), 20) << has_rays;
        if (has_rays) {
            EXPECT_NEAR(quantile(c, 0.5), 1, 0.3);
        }
    }
}

TEST(ScreenCurvature, ABumpMapCurvesAsMuchAsItTurnsTheNormal) {
    const int size = 200;
    const float height = 0.05f, wave = 2 * kPi / 24;  // of the normal's x, 24 pixels long
    AovFrame bumpy = roof_frame(size, 0);
    change_normals(bumpy, [&](const Vec3f& n, int x, int) { return n + Vec3f(height * std::sin(wave * x), 0, 0); });
    const float step = 0.4f / size * 6;
    EXPECT_NEAR(quantile(curvatures(bumpy), 0.999), height * wave / step, 0.1f * height * wave / step);
}
