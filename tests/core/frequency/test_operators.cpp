// The operators by hand, and what they come down to against how reflected directions really change from pixel to pixel.
#include "core/scenes.h"

#include <burnish/frequency/operators.h>

#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish::transport;

namespace {

constexpr float kMirror = std::numeric_limits<float>::infinity();

// Every operator once, on numbers easy to follow.
static_assert(FreeSpace{3}({2, 10}) == Bandwidth{2, 4});
static_assert(IntoSurface{0.5f}({2, 10}) == Bandwidth{1, 10});
static_assert(OutOfSurface{0.5f}({2, 10}) == Bandwidth{4, 10});
static_assert(Curvature{0.25f}({2, 8}) == Bandwidth{4, 8});
static_assert(Mirror{}({2, 8}) == Bandwidth{2, -8});
static_assert(Reflectance{5, 4}({2, 8}) == Bandwidth{7, 4} && Reflectance{5, 4}({2, -8}) == Bandwidth{7, -4});
static_assert(CorrelatedReflectance{5, 4}({2, 8}) == Bandwidth{6, 4} && CorrelatedReflectance{5, 9}({2, 8}) == Bandwidth{7, 8});

// Distant light nu_a 8, c 0.5, rho 2, cos_x 0.5, seen from 10: incident space 4; the published lobe keeps it, (4, 2); S and C_-c
// give (4 + 1, -2), P_x (10, -2), T (10, 102). Correlated: space 1, (2 / 0.5, -2), 2 + 10 * 4.
static_assert(reflected_source({0, 8}, {0.3f, 0.5f, 0.5f, 0, 2}) == Bandwidth{10, -2});
static_assert(at_camera(reflected_source({0, 8}, {0.3f, 0.5f, 0.5f, 0, 2}), 10) == Bandwidth{10, 102});
static_assert(at_camera(reflected_correlated({0, 8}, {0.3f, 0.5f, 0.5f, 0, 2}), 10) == Bandwidth{4, 42});

/// Pixel of a frame, as vectors.
struct Seen {
    Vec3f p, n, wo, r;  // r: reflected direction
    bool is_surface;
};

Seen seen(const AovFrame& frame, int x, int y) {
    const float *p = frame.layer(Role::position).at(x, y), *n = frame.layer(Role::normal).at(x, y);
    Seen s{{p[0], p[1], p[2]}, {n[0], n[1], n[2]}, {}, {}, n[0] != 0 || n[1] != 0 || n[2] != 0};
    s.wo = (frame.camera->centre - s.p).normalized();
    s.r = s.n * (2 * s.n.dot(s.wo)) - s.wo;
    return s;
}

/// The larger singular value of (dx, dy).
float stretch(const Vec3f& dx, const Vec3f& dy) {
    const float xx = dx.dot(dx), xy = dx.dot(dy), yy = dy.dot(dy);
    return std::sqrt(0.5f * (xx + yy + std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy)));
}

/// How far a direction moves per pixel, in the screen direction where it moves most.
template <class Direction>
float per_pixel(const AovFrame& frame, int x, int y, const Direction& of) {
    return stretch((of(seen(frame, x + 1, y)) - of(seen(frame, x - 1, y))) / 2.0f,
                   (of(seen(frame, x, y + 1)) - of(seen(frame, x, y - 1))) / 2.0f);
}

/// Calls visit(pixel, |d view| and |d reflected| per pixel) for the inner pixels of a surface.
template <class Visit>
int for_each_inner_pixel(const AovFrame& frame, const Visit& visit) {
    int count = 0;
    const Image& normal = frame.layer(Role::normal);
    for (int y = 2; y < normal.height - 2; y += 5)
        for (int x = 2; x < normal.width - 2; x += 5) {
            const Seen s = seen(frame, x, y);
            if (!s.is_surface || s.n.dot(s.wo) < 0.3f) continue;
            ++count;
            visit(s, per_pixel(frame, x, y, [](const Seen& i) { return i.wo; }),
                  per_pixel(frame, x, y, [](const Seen& i) { return i.r; }));
        }
    return count;
}

/// The plane y = -1 seen at a grazing angle from (0, 0, 6), all pixels below the horizon.
AovFrame plane_frame(int size) {
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, size, size};
    Image position(size, size, 3), normal(size, size, 3);
    const Vec3f eye(0, 0, 6);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3f d(2 * (x + 0.5f) / size - 1, -0.2f - 1.5f * (y + 0.5f) / size, -2), p = eye + d / -d.y, n(0, 1, 0);
            std::copy_n(&p.x, 3, position.at(x, y)), std::copy_n(&n.x, 3, normal.at(x, y));
        }
    frame.layers[Role::position] = std::move(position), frame.layers[Role::normal] = std::move(normal);
    frame.camera = Camera{};
    frame.camera->centre = eye;
    return frame;
}

constexpr float kLight = 40;

}  // namespace

TEST(Operators, UnderDistantLightTheyFollowTheReflectedDirectionOverASphere) {
    const AovFrame frame = scenes::sphere_frame(200);
    for (const float rho : {5.0f, 25.0f, 80.0f}) {
        const float kept = std::min(rho, kLight);
        const int count = for_each_inner_pixel(frame, [&](const Seen& s, float view, float turned) {
            const Reflection r{s.r.dot(s.n), s.wo.dot(s.n), 1, 0, rho};
            const float d = (s.p - frame.camera->centre).length();
            const float correlated = at_camera(reflected_correlated({0, kLight}, r), d).nu_a * view;
            const float source = at_camera(reflected_source({0, kLight}, r), d).nu_a * view;
            EXPECT_NEAR(correlated, kept * turned, 0.02f * kept * turned);
            const float published = kept * view + 0.5f * (kLight + kept) * (turned - view);
            EXPECT_NEAR(source, published, 0.02f * published);
            // The view's own turn is a small part on a sphere this far away.
            EXPECT_NEAR(source, 0.5f * (kLight + kept) * turned, 0.12f * source);
            EXPECT_NEAR(reflection_turn(1, r.cos_x, d) * view, turned, 0.02f * turned);
        });
        EXPECT_GT(count, 500);
    }
}

TEST(Operators, APlaneKeepsTheAngleOfDistantLight) {
    const AovFrame frame = plane_frame(100);
    const int count = for_each_inner_pixel(frame, [&](const Seen& s, float view, float turned) {
        EXPECT_NEAR(turned, view, 0.01f * view);
        const Reflection r{s.r.dot(s.n), s.wo.dot(s.n), 0, 0, 12};
        EXPECT_EQ(at_camera(reflected_correlated({0, kLight}, r), 7).nu_a, 12);
        EXPECT_EQ(at_camera(reflected_source({0, kLight}, r), 7).nu_a, 12);
    });
    EXPECT_GT(count, 100);
}

TEST(Operators, ATextureIsSquashedByGrazingViews) {
    const AovFrame frame = plane_frame(200);
    const int count = for_each_inner_pixel(frame, [&](const Seen& s, float view, float) {
        // Stripes along the view's azimuth, t cycles a unit: how many pass per pixel.
        const Vec3f along = (s.wo - s.n * s.n.dot(s.wo)).normalized();
        const float d = (s.p - frame.camera->centre).length(), t = 3;
        const Bandwidth nu = at_camera(reflected_source({0, 0}, {1, s.wo.dot(s.n), 0, t, kMirror}), d);
        EXPECT_FLOAT_EQ(nu.nu_a, t * d / s.wo.dot(s.n));
        const Vec3f turned = (s.wo + s.wo.cross(s.n.cross(s.wo)).normalized() * view).normalized();
        const auto on_plane = [&](const Vec3f& w) { return frame.camera->centre - w * ((frame.camera->centre.y + 1) / w.y); };
        const float cycles = t * std::abs((on_plane(turned) - on_plane(s.wo)).dot(along));
        EXPECT_NEAR(nu.nu_a * view, cycles, 0.1f * cycles);
    });
    EXPECT_GT(count, 100);
}

TEST(Operators, ANearLampOverAConvexMirrorAddsUp) {
    // Stripes on a screen at distance d, seen from d' over a mirror of curvature c: while the view turns by e, the mirrored ray turns
    // by (1 + 2 c d' / cos) e and starts d' e further on.
    for (const float d : {0.5f, 2.0f, 20.0f})
        for (const float c : {0.0f, 0.3f, 4.0f})
            for (const float cos : {1.0f, 0.4f}) {
                const float nu_s = 7, from_eye = 5;
                const float truth = nu_s * (d * reflection_turn(c, cos, from_eye) + from_eye);
                const Bandwidth light = FreeSpace{d}({nu_s, 0});
                EXPECT_NEAR(at_camera(reflected_source(light, {cos, cos, c}), from_eye).nu_a, truth, 1e-4f * truth);
            }
}

TEST(Operators, TheSourceIsNeverBelowTheCorrelatedAndAMirrorMakesThemEqual) {
    for (const Bandwidth light : {Bandwidth{0, 30}, {4, 0}, {4, -20}, {-4, 20}, {3, 11}})
        for (const float c : {-6.0f, -0.1f, 0.0f, 0.2f, 8.0f})
            for (const float rho : {0.0f, 1.0f, 10.0f, 25.0f, kMirror})
                for (const float t : {0.0f, 2.0f}) {
                    const Reflection r{0.7f, 0.4f, c, t, rho};
                    const Bandwidth source = at_camera(reflected_source(light, r), 5);
                    const Bandwidth correlated = at_camera(reflected_correlated(light, r), 5);
                    EXPECT_GE(source.nu_a, correlated.nu_a);
                    EXPECT_GE(source.nu_s, correlated.nu_s);
                    if (rho == kMirror) {
                        EXPECT_EQ(source, correlated);
                    }
                    const Reflection turned{0.7f, 0.4f, -c, t, rho};
                    EXPECT_EQ(at_camera(reflected_source({-light.nu_s, -light.nu_a}, turned), 5), source);
                    EXPECT_EQ(at_camera(reflected_correlated({-light.nu_s, -light.nu_a}, turned), 5), correlated);
                }
}
