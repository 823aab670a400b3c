// Where rays end: planes, boxes and meshes against the closed form, distances against ray tracing, and no tears between.
#include "painted_room.h"

#include <burnish/base/error.h>
#include <burnish/light/cube_map/proxy.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

const Vec3f kCentre(0.5f, 0.2f, -0.7f);

std::vector<RayEnd> ends_of(const Proxy& proxy, const std::vector<LightRay>& rays) {
    std::vector<RayEnd> ends;
    std::visit([&](const auto& one) { one.ends(rays, ends); }, proxy);
    return ends;
}

RayEnd end_of(const Proxy& proxy, const Vec3f& p, const Vec3f& d) { return ends_of(proxy, {{p, d, d, 0}})[0]; }

Proxy impostor(const PaintedRoom& room, int size, const Vec3f& centre = kCentre) {
    return DepthImpostor(std::make_shared<DistanceMap>(room.distances(centre, size), EnvironmentSettings(), DistanceKind::ray),
                         centre);
}

float degrees(float radian) { return radian * 180 / kPi; }
float angle(const Vec3f& a, const Vec3f& b) { return std::atan2(a.cross(b).length(), a.dot(b)); }

/// Angles, seen from the centre, between where rays end and where they should: of those that end where it sees them.
struct Errors {
    std::vector<float> sorted;

    Errors(const PaintedRoom& room, const Proxy& proxy, float margin) {
        Directions random;
        for (int i = 0; i < 20000; ++i) {
            const Vec3f p = room.inside(random, margin), d = random.next();
            const Vec3f x = room.end(p, d).x;
            if (room.in_block(p) || (room.end(kCentre, (x - kCentre).normalized()).x - x).length() > 1e-3f) continue;
            sorted.push_back(angle(end_of(proxy, p, d).from_centre, x - kCentre));
        }
        std::sort(sorted.begin(), sorted.end());
    }
    float quantile(double q) const { return sorted[static_cast<size_t>(q * static_cast<double>(sorted.size() - 1))]; }
    double share_above(float limit) const {
        return static_cast<double>(sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), limit)) /
               static_cast<double>(sorted.size());
    }
};

/// The largest turn between neighbours of `steps` steps along `ray(s)`, s in [0, 1].
template <class Ray>
float largest_turn(const Proxy& proxy, int steps, const Ray& ray) {
    float largest = 0;
    Vec3f before;
    for (int i = 0; i <= steps; ++i) {
        const auto [p, d] = ray(static_cast<float>(i) / static_cast<float>(steps));
        const Vec3f here = end_of(proxy, p, d).from_centre;
        if (i > 0) largest = std::max(largest, angle(before, here));
        before = here;
    }
    return largest;
}

struct PointAndWay {
    Vec3f p, d;
};

}  // namespace

TEST(Proxies, PlanesBoxesAndMeshesMeetTheWalls) {
    const PaintedRoom room;
    const Proxy proxies[] = {BoundingPlanes(room.planes(), kCentre), BoundingPlanes(room.box(), kCentre),
                             ProxyMesh(room.scene(), kCentre)};
    Directions random;
    for (int i = 0; i < 5000; ++i) {
        const Vec3f p = room.inside(random, 0.05f), d = random.next(), x = room.end(p, d).x;
        for (const Proxy& proxy : proxies) {
            const RayEnd end = end_of(proxy, p, d);
            ASSERT_LT((end.from_centre + kCentre - x).length(), 2e-4f) << proxy.index() << p << d;
            ASSERT_NEAR(end.distance, (x - p).length(), 2e-4f);
            ASSERT_NEAR(std::max({std::fabs(end.n.x), std::fabs(end.n.y), std::fabs(end.n.z)}), 1, 1e-5f);
        }
    }
}

TEST(Proxies, TurnedBoxesAreMetInTheirOwnAxes) {
    OrientedBox box = standing_block();
    box.centre = {0, 0, 0};
    const Proxy proxy = BoundingPlanes(box, {0.1f, 0, 0});
    Directions random;
    for (int i = 0; i < 1000; ++i) {
        const Vec3f x = end_of(proxy, {0.2f, 0.1f, -0.1f}, random.next()).from_centre + Vec3f(0.1f, 0, 0);
        const Vec3f local(std::fabs(x.dot(box.x)) / box.half.x, std::fabs(x.dot(box.y)) / box.half.y,
                          std::fabs(x.dot(box.z)) / box.half.z);
        ASSERT_NEAR(std::max({local.x, local.y, local.z}), 1, 1e-4f);
    }
}

TEST(Proxies, FloorAndCeilingAloneLeaveTheHorizonInfinite) {
    const PaintedRoom room;
    const std::vector<Plane> planes = {room.planes()[2], room.planes()[3]};
    const Proxy proxy = BoundingPlanes(planes, kCentre);
    const RayEnd level = end_of(proxy, {1, 0, 0}, {1, 0, 0});
    EXPECT_FALSE(level.is_somewhere());
    EXPECT_EQ(level.from_centre, Vec3f(1, 0, 0));
    const RayEnd down = end_of(proxy, {1, 0, 0}, Vec3f(1, -0.25f, 0).normalized());
    EXPECT_NEAR(down.from_centre.y + kCentre.y, room.low.y, 1e-5f);
    EXPECT_NEAR(down.from_centre.x + kCentre.x, 1 + 4, 1e-4f);
}

// Where a map jumps, the largest turn between neighbours stays however fine the steps; where it does not, it shrinks with them.
TEST(Proxies, NoTearsAlongDirectionsAndPlaces) {
    const PaintedRoom room;
    const std::vector<Plane> two = {room.planes()[2], room.planes()[3]};
    const Proxy proxies[] = {BoundingPlanes(room.planes(), kCentre), BoundingPlanes(two, kCentre), impostor(room, 64)};
    const auto turning = [](const Vec3f& p) {
        return [p](float s) {
            const float phi = 2 * kPi * s, z = 0.4f * std::sin(5 * phi), r = std::sqrt(1 - z * z);
            return PointAndWay{p, {r * std::cos(phi), z, r * std::sin(phi)}};
        };
    };
    const auto walking = [&](const Vec3f& d) {
        return [&room, d](float s) { return PointAndWay{{0.3f, room.low.y - 0.1f + 0.4f * s, 0.8f}, d.normalized()}; };
    };
    for (const Proxy& proxy : proxies) {
        const bool planes = std::holds_alternative<BoundingPlanes>(proxy);
        for (const Vec3f& p : {Vec3f(0, 0, 0), Vec3f(-2.5f, 1.5f, 3.5f), Vec3f(1, room.low.y + 0.05f, 1)}) {
            const float coarse = largest_turn(proxy, 4000, turning(p)), fine = largest_turn(proxy, 32000, turning(p));
            EXPECT_LT(fine, 0.3f * coarse) << proxy.index() << p;
        }
        if (!planes) continue;
        for (const Vec3f& p : {Vec3f(1, room.low.y, 1), Vec3f(1, room.low.y - 0.02f, 1)}) {
            const float fine = largest_turn(proxy, 32000, turning(p)), finest = largest_turn(proxy, 256000, turning(p));
            EXPECT_LT(finest, 0.3f * fine) << p;
        }
        for (const Vec3f& d : {Vec3f(1, -0.3f, 0.2f), Vec3f(0.1f, -1, 0), Vec3f(1, 0.2f, 0.4f)}) {
            const float coarse = largest_turn(proxy, 4000, walking(d)), fine = largest_turn(proxy, 32000, walking(d));
            EXPECT_LT(fine, 0.3f * coarse) << d;
        }
    }
    PaintedRoom blocked = room;
    blocked.block = standing_block();
    EXPECT_GT(largest_turn(impostor(blocked, 64), 32000, turning({0, 0, 0})), 0.1f) << "what jumps must show";
}

TEST(Proxies, ConesThatStraddleAnEdgeAreSharedOut) {
    const PaintedRoom room;
    const Proxy proxy = BoundingPlanes(room.planes(), kCentre);
    Directions random;
    int shared = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3f d = random.next();
        const std::vector<RayEnd> ends = ends_of(proxy, {{{1, 0.5f, 1}, d, d, 0.1f}});
        float total = 0;
        for (const RayEnd& end : ends) total += end.share;
        ASSERT_NEAR(total, 1, 1e-5f);
        shared += ends.size() > 1;
    }
    EXPECT_GT(shared, 200);
    const Vec3f edge = (Vec3f(room.high.x, room.low.y, 0.5f) - Vec3f(1, 0, 0.5f)).normalized();
    const std::vector<RayEnd> halves = ends_of(proxy, {{{1, 0, 0.5f}, edge, edge, 0.05f}});
    ASSERT_EQ(halves.size(), 2u);
    EXPECT_NEAR(halves[0].share, 0.5f, 1e-3f);
}

TEST(Proxies, DistancesOfAConvexRoomAreMetExactly) {
    const PaintedRoom room;
    const Errors coarse(room, impostor(room, 32), 0.05f), fine(room, impostor(room, 128), 0.05f);
    std::printf("convex room: 32 texels median %.5f p99 %.4f largest %.3f, 128: %.5f %.4f %.3f degrees\n",
                degrees(coarse.quantile(0.5)), degrees(coarse.quantile(0.99)), degrees(coarse.quantile(1)),
                degrees(fine.quantile(0.5)), degrees(fine.quantile(0.99)), degrees(fine.quantile(1)));
    EXPECT_LT(degrees(fine.quantile(0.5)), 0.001f);
    EXPECT_LT(degrees(fine.quantile(0.99)), 0.2f);
    EXPECT_LT(degrees(fine.quantile(1)), 2.0f);
    EXPECT_LT(fine.quantile(0.99), 0.5f * coarse.quantile(0.99));
}

TEST(Proxies, DistancesOfARoomWithABlock) {
    PaintedRoom room;
    room.block = standing_block();
    const Errors own(room, impostor(room, 256), 0.05f), box(room, BoundingPlanes(room.box(), kCentre), 0.05f);
    for (const Errors* e : {&own, &box})
        std::printf("block: median %.4f, beyond 0.5 degrees %.2f %%, beyond 5 degrees %.2f %%\n", degrees(e->quantile(0.5)),
                    100 * e->share_above(0.5f / 180 * kPi), 100 * e->share_above(5.0f / 180 * kPi));
    EXPECT_LT(own.share_above(0.5f / 180 * kPi), 0.002);
    EXPECT_GT(box.share_above(0.5f / 180 * kPi), 5 * own.share_above(0.5f / 180 * kPi));
}

TEST(Proxies, PlanarDistancesAndLengthsOfRaysAreToldApart) {
    PaintedRoom room;
    room.block = standing_block();
    const DistanceMap rays(room.distances(kCentre, 64), {}, DistanceKind::automatic),
        planar(room.distances(kCentre, 64, DistanceKind::planar), {}, DistanceKind::automatic),
        wrong(room.distances(kCentre, 64, DistanceKind::planar), {}, DistanceKind::ray);
    Directions random;
    float worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3f d = random.next();
        ASSERT_NEAR(rays.nearer(d), planar.nearer(d), 1e-4f);
        worst = std::max(worst, std::fabs(wrong.nearer(d) / rays.nearer(d) - 1));
    }
    EXPECT_GT(worst, 0.4f);
}

TEST(Proxies, NothingSeenIsInfinitelyFar) {
    EnvironmentPicture picture;
    picture.faces.emplace();
    for (Image& face : *picture.faces) face = Image(16, 16, 1, 1e10f);
    const Proxy proxy = DepthImpostor(
        std::make_shared<DistanceMap>(std::move(picture), EnvironmentSettings(), DistanceKind::automatic), kCentre);
    EXPECT_FALSE(end_of(proxy, {1, 0, 0}, {0, 1, 0}).is_somewhere());
    EXPECT_FALSE(end_of(proxy, kCentre, {0, 1, 0}).is_somewhere());
}

TEST(Proxies, RefuseWhatStandsForNoRoom) {
    const auto refused = [](const auto& make, const char* what) {
        try {
            make();
            ADD_FAILURE() << what << " was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::bad_argument);
            EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
        }
    };
    const auto planes = [](std::vector<Plane> list) { return BoundingPlanes(list, kCentre); };
    refused([&] { planes({}); }, "no planes");
    refused([&] { planes({{{0, 0, 0}, {0, 0, 0}}}); }, "normal");
    refused([&] { planes({{kCentre, {0, 1, 0}}}); }, "centre");
    const auto box = [](const OrientedBox& b) { return BoundingPlanes(b, kCentre); };
    refused([&] { box({{0, 0, 0}, {1, 0, 1}}); }, "half edges");
    refused([&] { box({{9, 0, 0}, {1, 1, 1}}); }, "outside");
    refused([&] { box({{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {1, 0, 0}}); }, "perpendicular");
}
