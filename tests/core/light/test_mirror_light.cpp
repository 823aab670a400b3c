// Light of mirrored renders against ray casting of the room that they show.
#include "box_room.h"
#include "depth_edges.h"

#include <burnish/light/mirror/mirror_light.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish_test;

namespace {

constexpr int kWidth = 640, kHeight = 360;

/// A place of the floor that the frame sees, and the pixel of the buffer where its mirror ray ends.
struct FloorPoint {
    Vec3f p, reflected;
    int x, y;
};

std::vector<FloorPoint> floor_points(const BoxRoom& room, int step) {
    const Camera camera = room_camera();
    std::vector<FloorPoint> points;
    for (int y = 0; y < kHeight; y += step)
        for (int x = 0; x < kWidth; x += step) {
            const Vec3f ray = camera.ray(screen_point(x, y, {0, 0, kWidth, kHeight})).normalized();
            const BoxRoom::Seen seen = room.look(camera.centre, ray);
            const Vec3f p = camera.centre - ray * (camera.centre.z / ray.z);
            if (ray.z < 0 && seen.place.z < 0 && std::fabs(p.x) < 3 && std::fabs(p.y) < 4)
                points.push_back({Vec3f(p.x, p.y, 0), Vec3f(ray.x, ray.y, -ray.z), kWidth - 1 - x, y});
        }
    return points;
}

LightRay ray_from(const Vec3f& p, const Vec3f& d, float sigma) { return {p, Vec3f(0, 0, 1), d.normalized(), sigma}; }

/// Directions about d with the density of a Gaussian `sigma` wide, Halton's.
std::vector<Vec3f> cone(const Vec3f& d, float sigma, int count) {
    const Frame frame = Frame::around(d);
    std::vector<Vec3f> directions;
    for (int i = 0; i < count; ++i) {
        float third = 0, scale = 1.0f / 3;
        for (int digit = i + 1; digit > 0; digit /= 3, scale /= 3) third += static_cast<float>(digit % 3) * scale;
        const float radius = sigma * std::sqrt(-2 * std::log(1 - (static_cast<float>(i) + 0.5f) / static_cast<float>(count)));
        directions.push_back(
            frame.to_world(Vec3f(radius * std::cos(2 * kPi * third), radius * std::sin(2 * kPi * third), 1)).normalized());
    }
    return directions;
}

/// Mean difference of luminance between what rays about the mirror's direction meet and what is read where they are found, over the
/// rays from near depth edges that end on what the picture sees.
double error_at_depth_edges(const BoxRoom& room, float sigma, int steps) {
    const MirrorBuffer buffer = floor_buffer(room);
    const MirrorView view(buffer.camera, buffer.data, buffer.display, buffer.position, buffer.normal);
    const Image near = near_depth_edges(buffer, 8);
    const PlanarStack picture(buffer.light);
    double error = 0, rays = 0;
    for (const FloorPoint& point : floor_points(room, 2))
        for (const Vec3f& d : cone(point.reflected, sigma, 16)) {
            const BoxRoom::Seen truth = room.look(point.p, d);
            const Vec3f from = buffer.camera.centre, way = truth.place - from;
            const bool is_seen = std::fabs(room.look(from, way.normalized()).distance - way.length()) < 1e-3f;
            const std::optional<Vec2f> screen = buffer.camera.project(truth.place);
            if (*near.at(point.x, point.y) == 0 || d.z < 0 || !is_seen || screen->length() > 1) continue;
            const PlanarStack::Value found = picture.lookup(view.find(point.p, d, steps).place, 0);
            error += std::fabs(luminance(found.radiance - truth.radiance)), ++rays;
        }
    return error / rays;
}

}  // namespace

TEST(MirrorLight, IsExactInTheMirrorsDirection) {
    const BoxRoom room = furnished_room();
    const MirrorLight light(floor_buffer(room), floor_mirror());
    for (const FloorPoint& point : floor_points(room, 3)) {
        const BoxRoom::Seen truth = room.look(point.p, point.reflected);
        const ExactLight found = light.exact(ray_from(point.p, point.reflected, 0));
        ASSERT_NEAR(found.cover, 1, 1e-3f);
        ASSERT_LT((found.radiance - truth.radiance).length(), 2e-3f) << point.x << " " << point.y;
    }
}

TEST(MirrorLight, MeetsTheSurfaceFoundAgain) {
    const BoxRoom room = furnished_room();
    for (const float sigma : {0.02f, 0.05f, 0.1f})
        EXPECT_LT(error_at_depth_edges(room, sigma, 3), 0.5 * error_at_depth_edges(room, sigma, 1)) << sigma;
}

TEST(MirrorLight, AveragesOverTheConeOnAWall) {
    const BoxRoom room({});
    const MirrorLight light(floor_buffer(room), floor_mirror());
    for (const Vec3f& p : {Vec3f(0.2f, 0.4f, 0), Vec3f(-0.5f, 2, 0), Vec3f(-1, 1, 0)})
        for (const float sigma : {0.01f, 0.03f, 0.06f}) {
            const Vec3f d = (p - mirrored(room_camera(), floor_mirror().plane).centre).normalized();
            Color3f truth(0, 0, 0);
            for (const Vec3f& one : cone(d, sigma, 4096)) truth += room.look(p, one).radiance / 4096;
            Incident found;
            const LightRay ray = ray_from(p, d, sigma);
            light.lookup({&ray, 1}, {&found, 1});
            EXPECT_NEAR(found.cover, 1, 5e-3f);
            EXPECT_LT((found.radiance - truth * found.cover).length(), 0.02f * truth.length()) << sigma;
            EXPECT_NEAR(found.nearness, 1 / room.look(p, d).distance, 1e-3f);
        }
}

TEST(MirrorLight, FadesWhereThePictureEnds) {
    const BoxRoom room = furnished_room();
    const MirrorLight light(floor_buffer(room), floor_mirror());
    const Vec3f p(0.1f, -1.5f, 0);
    for (const float sigma : {0.005f, 0.02f, 0.1f})
        for (const float slope : {0.0f, 1.0f, -2.0f}) {
            std::vector<LightRay> rays;
            for (float angle = 0; angle < 2 * kPi; angle += 0.05f * sigma)
                rays.push_back(ray_from(p, Vec3f(slope * std::sin(angle), std::cos(angle), std::sin(angle)), sigma));
            std::vector<Incident> found(rays.size());
            light.lookup(rays, found);
            float most = 0;
            for (size_t i = 0; i + 1 < rays.size(); ++i) {
                ASSERT_TRUE(std::isfinite(luminance(found[i].radiance)) && std::isfinite(found[i].bend));
                if (rays[i].d.z < -4 * sigma) {
                    ASSERT_EQ(found[i].cover, 0);
                }
                most = std::max(most, found[i].cover);
            }
            EXPECT_GT(most, 0.9f);
            EXPECT_EQ(found[rays.size() * 3 / 4].cover, 0);
        }
}

TEST(MirrorLight, HasNoSeamAtThePicturesEdges) {
    const MirrorLight light(floor_buffer(BoxRoom({})), floor_mirror());
    for (const float sigma : {0.005f, 0.02f, 0.1f}) {
        std::vector<LightRay> rays;
        for (float angle = 0.1f; angle < kPi - 0.1f; angle += 0.1f * sigma)
            rays.push_back(ray_from({0.1f, -1.5f, 0}, Vec3f(std::cos(angle), 0.4f, std::sin(angle)), sigma));
        std::vector<Incident> found(rays.size());
        light.lookup(rays, found);
        for (size_t i = 1; i < rays.size(); ++i)
            EXPECT_LT(std::fabs(found[i].cover - found[i - 1].cover), 0.15f) << sigma << " " << i;
    }
}

TEST(MirrorLight, SurvivesAnyRay) {
    const BoxRoom room = furnished_room();
    const MirrorBuffer buffer = floor_buffer(room, 64, 36);
    const MirrorLight light(buffer, floor_mirror());
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::vector<LightRay> rays;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f p(4 * uniform(random), 5 * uniform(random), i % 3 ? 0.0f : 4 * uniform(random));
        rays.push_back(ray_from(p, {uniform(random), uniform(random), uniform(random)}, std::fabs(uniform(random))));
    }
    rays.push_back(ray_from(buffer.camera.centre, {0, 0, 1}, 0.1f));
    rays.push_back(ray_from(Vec3f(std::nanf("")), {0, 0, 1}, 0.1f));
    rays.push_back(ray_from({0, 0, 0}, {1, 0, 0}, 0));
    std::vector<Incident> all(rays.size());
    light.lookup(rays, all);
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_TRUE(std::isfinite(luminance(all[i].radiance)) && std::isfinite(all[i].bend) && std::isfinite(all[i].nearness));
        ASSERT_TRUE(all[i].cover >= 0 && all[i].cover <= 1.0001f);
        Incident alone;
        light.lookup({&rays[i], 1}, {&alone, 1});
        ASSERT_EQ(std::memcmp(&alone, &all[i], sizeof alone), 0) << "depends on its batch";
    }
}

TEST(MirrorLight, BearsPointsBesideThePlane) {
    const BoxRoom room = furnished_room();
    const MirrorLight light(floor_buffer(room), floor_mirror());
    double error = 0, sum = 0;
    for (const FloorPoint& point : floor_points(room, 5)) {
        const Vec3f beside = point.p + Vec3f(0.7f, -0.6f, (point.x % 2 ? 1.0f : -1.0f)) * 1e-3f;
        const ExactLight found = light.exact(ray_from(beside, point.reflected, 0));
        error += (found.radiance - room.look(point.p, point.reflected).radiance).length(), sum += found.radiance.length();
    }
    EXPECT_LT(error, 0.01 * sum);
}

TEST(MirrorLight, SeesThroughAPane) {
    const BoxRoom room = furnished_room();
    MirrorSettings pane;
    pane.behind = true, pane.plane = {Vec3f(0, -1, 1), Vec3f(0, 1, 0)};
    const Camera camera = room_camera();
    const MirrorLight light(MirrorBuffer::from_frame(room.render(camera, kWidth, kHeight)), pane);
    for (const float x : {-0.8f, 0.1f, 0.9f}) {
        const Vec3f p(x, -1, 1.4f), d = (p - camera.centre).normalized();
        const ExactLight through = light.exact({p, Vec3f(0, -1, 0), d, 0});
        EXPECT_LT((through.radiance - room.look(p, d).radiance).length(), 0.02f);
        EXPECT_NEAR(through.cover, 1, 1e-3f);
        EXPECT_EQ(light.exact({p, Vec3f(0, -1, 0), Vec3f(d.x, -d.y, d.z), 0}).cover, 0) << "the viewer's side";
    }
}

TEST(MirrorLight, ScalesItsRadiance) {
    const MirrorBuffer buffer = floor_buffer(furnished_room(), 64, 36);
    const LightRay ray = ray_from({0.1f, 0, 0}, {0, 1, 0.6f}, 0.02f);
    const ExactLight plain = MirrorLight(buffer, floor_mirror()).exact(ray);
    const ExactLight tinted = MirrorLight(buffer, floor_mirror(), Color3f(2, 3, 0.5f)).exact(ray);
    EXPECT_LT((tinted.radiance - plain.radiance * Color3f(2, 3, 0.5f)).length(), 1e-5f);
}

TEST(MirrorLight, SeesTheSkyOnlyIfThePictureHoldsIt) {
    AovFrame frame = furnished_room().render(mirrored(room_camera(), floor_mirror().plane), kWidth, kHeight);
    Image &position = frame.layers[Role::position], &beauty = frame.layers[Role::beauty];
    std::vector<size_t> outside;
    for (size_t i = 0; i < position.pixel_count(); ++i)
        if (position.at(i)[1] > 3.99f) outside.push_back(i), std::fill_n(position.at(i), 3, 0.0f);
    const auto fill = [&](float value) {
        for (const size_t i : outside) std::fill_n(beauty.at(i), 3, value);
    };
    const Vec3f p(-0.5f, 1, 0), d = (p - frame.camera->centre).normalized();
    fill(0);
    EXPECT_EQ(MirrorLight(MirrorBuffer::from_frame(frame), floor_mirror()).exact(ray_from(p, d, 0)).cover, 0);
    fill(0.7f);
    const MirrorLight sky(MirrorBuffer::from_frame(frame), floor_mirror());
    EXPECT_NEAR(sky.exact(ray_from(p, d, 0)).radiance.x, 0.7f, 1e-3f);
    EXPECT_NEAR(sky.exact(ray_from(p, d + Vec3f(0.03f, 0, 0.02f), 0)).cover, 1, 1e-3f) << "beside the mirror's direction";
    frame.layers[Role::alpha] = Image(kWidth, kHeight, 1, 0.25f);
    EXPECT_NEAR(MirrorLight(MirrorBuffer::from_frame(frame), floor_mirror()).exact(ray_from(p, d, 0)).cover, 0.25f, 1e-3f);
}
