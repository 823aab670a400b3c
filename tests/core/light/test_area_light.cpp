// Area lights against closed forms and plain sums: what a cone sees, what a ray hits, what is drawn.
#include "core/chi_square.h"

#include <burnish/base/error.h>
#include <burnish/light/area/area_light.h>
#include <burnish/sampling/sequence.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

const std::vector<Vec3f> kSquare{{-1, -0.6f, 2}, {-1, 0.6f, 2}, {1, 0.6f, 2}, {1, -0.6f, 2}};  // shines down
const std::vector<Vec3f> kTriangle{{0.3f, 0.2f, 1}, {1.2f, 1, 1.5f}, {0.9f, -0.4f, 1.3f}};
const std::vector<Vec3f> kPentagon{{0, 1, 2}, {0.9f, 0.3f, 2}, {0.6f, -0.8f, 2}, {-0.6f, -0.8f, 2}, {-0.9f, 0.3f, 2}};

AreaSettings settings_of(const std::vector<Vec3f>& corners, bool two_sided = false) {
    AreaSettings settings;
    settings.corners = corners, settings.two_sided = two_sided, settings.radiance = Color3f(2, 3, 4);
    return settings;
}

Image picture() {
    Image image(8, 4, 3);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y)[c] = 0.1f + static_cast<float>((x * 5 + y * 3 + c) % 7);
    return image;
}

LightRay ray(const Vec3f& d, float sigma, const Vec3f& ng = {0, 0, 1}) { return {{0, 0, 0}, ng, d.normalized(), sigma}; }

Incident look(const AreaLight& light, const LightRay& r) {
    Incident found;
    light.lookup({&r, 1}, {&found, 1});
    return found;
}

/// Irradiance of a horizontal surface at the origin under unit radiance: Lambert's sum over the edges.
double lambert(const std::vector<Vec3f>& corners) {
    double sum = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Imath::V3d a = Imath::V3d(corners[i]).normalized(),
                         b = Imath::V3d(corners[(i + 1) % corners.size()]).normalized();
        sum += std::acos(a.dot(b)) * a.cross(b).normalized().z;
    }
    return std::fabs(sum) / 2;
}

/// The Gaussian's share of a parallelogram by midpoints.
double share_by_sum(const std::vector<Vec3f>& corners, const Vec3f& d, double sigma) {
    const Imath::V3d origin(corners[0]), u(corners[1] - corners[0]), v(corners[3] - corners[0]), normal = u.cross(v);
    const int steps = 400;
    double sum = 0;
    for (int y = 0; y < steps; ++y)
        for (int x = 0; x < steps; ++x) {
            const Imath::V3d p = origin + u * ((x + 0.5) / steps) + v * ((y + 0.5) / steps);
            const double r = p.length();
            sum += std::fabs(p.dot(normal)) / (r * r * r) * std::exp((p.dot(Imath::V3d(d)) / r - 1) / (sigma * sigma));
        }
    return sum / (steps * steps) / (2 * std::numbers::pi * sigma * sigma * (1 - std::exp(-2 / (sigma * sigma))));
}

}  // namespace

TEST(AreaLight, AConeSeesItsGaussiansShare) {
    const AreaLight light(settings_of(kSquare));
    for (const float sigma : {0.03f, 0.1f, 0.3f, 0.5f})
        for (const Vec3f& d :
             {Vec3f(0, 0, 1), Vec3f(0.3f, 0.3f, 1), Vec3f(0.5f, 0.2f, 1), Vec3f(0.2f, 0.8f, 1), Vec3f(2, 0, 1)}) {
            const Incident seen = look(light, ray(d, sigma));
            EXPECT_NEAR(seen.cover, share_by_sum(kSquare, d.normalized(), sigma), sigma < 0.2f ? 0.002 : 0.008) << sigma << d;
            EXPECT_FLOAT_EQ(seen.radiance.y, 3 * seen.cover);
        }
}

TEST(AreaLight, SixAroundAPointCoverEveryCone) {
    const auto turned = [](const Vec3f& v, int side) {
        const Vec3f cycled = side / 2 == 0 ? v : side / 2 == 1 ? Vec3f(v.z, v.x, v.y) : Vec3f(v.y, v.z, v.x);
        return side % 2 == 0 ? cycled : -cycled;
    };
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 100; ++i) {
        const Vec3f d = Vec3f(normal(random), normal(random), normal(random)).normalized();
        float sum = 0;
        for (int side = 0; side < 6; ++side) {
            std::vector<Vec3f> corners;
            for (const Vec3f& corner : {Vec3f(-1, -1, 1), Vec3f(1, -1, 1), Vec3f(1, 1, 1), Vec3f(-1, 1, 1)})
                corners.push_back(turned(corner, side));
            sum += look(AreaLight(settings_of(corners, true)), ray(d, 0.2f, d)).cover;
        }
        EXPECT_NEAR(sum, 1, 0.01f) << d;
    }
}

TEST(AreaLight, ANarrowConeSeesWhatTheRayHits) {
    const AreaLight light(settings_of(kSquare), Color3f(1), picture());
    for (const Vec2f& at : {Vec2f(-0.7f, 0.3f), Vec2f(0.1f, -0.2f), Vec2f(0.55f, 0.45f)}) {
        const LightRay r = ray({at.x, at.y, 2}, 1e-5f);
        const ExactLight exact = light.exact(r);
        EXPECT_EQ(exact.cover, 1);
        EXPECT_LT((look(light, r).radiance - exact.radiance).length(), 0.02f * exact.radiance.length());
    }
    EXPECT_EQ(light.exact(ray({1.1f, 0, 2}, 0)).cover, 0);
}

TEST(AreaLight, PicturesLieAsTheCornersSay) {
    Image image(2, 2, 3);
    image.at(0, 1)[0] = 8;  // lower left
    image.at(1, 1)[1] = 8;  // lower right
    const AreaLight light(settings_of(kSquare), Color3f(1), image);
    const auto seen = [&](int corner) {
        return light.exact(ray(kSquare[static_cast<size_t>(corner)] * 0.99f + Vec3f(0, 0, 0.02f), 0));
    };
    EXPECT_GT(seen(0).radiance.x, 10);
    EXPECT_GT(seen(1).radiance.y, 10);
    EXPECT_LT(luminance(seen(2).radiance), 1);
    EXPECT_LT(luminance(seen(3).radiance), 1);
}

TEST(AreaLight, ShinesToItsSides) {
    std::vector<Vec3f> away(kSquare.rbegin(), kSquare.rend());
    const LightRay up = ray({0, 0, 1}, 0.1f);
    EXPECT_EQ(look(AreaLight(settings_of(away)), up).cover, 0);
    EXPECT_EQ(AreaLight(settings_of(away)).exact(up).cover, 0);
    EXPECT_EQ(AreaLight(settings_of(away)).sample({0, 0, 0}, {0.5f, 0.5f}).pdf, 0);
    EXPECT_GT(look(AreaLight(settings_of(away, true)), up).cover, 0.9f);
    EXPECT_GT(AreaLight(settings_of(away, true)).sample({0, 0, 0}, {0.5f, 0.5f}).pdf, 0);
}

TEST(AreaLight, NothingShinesFromBelowTheHorizon) {
    EXPECT_EQ(look(AreaLight(settings_of(kSquare)), ray({0, 0, 1}, 0.3f, {0, 0, -1})).cover, 0);
    LightRay through = ray({0, 0, 1}, 0.3f, {0, 0, -1});
    through.side = -1;
    EXPECT_GT(look(AreaLight(settings_of(kSquare)), through).cover, 0.5f);
}

TEST(AreaLight, AnyPointAndConeIsSafe) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(-2, 2);
    for (const Image& image : {Image(), picture()}) {
        const AreaLight light(settings_of(kSquare, true), Color3f(1), image);
        for (int i = 0; i < 3000; ++i) {
            LightRay r = ray({uniform(random), uniform(random), uniform(random)}, std::pow(10.0f, 3 * uniform(random)));
            r.p = i % 3 == 0 ? kSquare[static_cast<size_t>(i / 3 % 4)]
                             : Vec3f(uniform(random), uniform(random), i % 3 == 1 ? 2.0f : 1.9999f);
            const Incident seen = look(light, r);
            EXPECT_TRUE(is_finite(seen.radiance) && std::isfinite(seen.bend) && std::isfinite(seen.nearness));
            EXPECT_TRUE(seen.cover >= 0 && seen.cover <= 1 && seen.bend >= 0);
            const LightDraw draw = light.sample(r.p, {0.5f + uniform(random) / 4.01f, 0.5f + uniform(random) / 4.01f});
            EXPECT_TRUE(is_finite(draw.d) && std::isfinite(draw.pdf));
        }
    }
}

TEST(AreaLight, BendBoundsTheSecondDifferences) {
    for (const Image& image : {Image(), picture()}) {
        const AreaLight light(settings_of(kSquare), Color3f(1), image);
        for (const float sigma : {0.05f, 0.15f})
            for (int i = 0; i < 60; ++i) {
                const float angle = -0.8f + 1.6f * static_cast<float>(i) / 60, step = 0.5f * sigma;
                const auto value = [&](float a) {
                    return luminance(look(light, ray({std::sin(a), 0.1f, std::cos(a)}, sigma)).radiance);
                };
                const float bent = (value(angle - step) - 2 * value(angle) + value(angle + step)) / (step * step);
                EXPECT_LE(std::fabs(bent), 1.1f * look(light, ray({std::sin(angle), 0.1f, std::cos(angle)}, sigma)).bend)
                    << angle;
            }
    }
}

TEST(AreaLight, DrawsGiveLambertsIrradiance) {
    for (const auto& corners : {kSquare, kTriangle, kPentagon}) {
        const AreaLight light(settings_of(corners, true));
        double sum = 0;
        const uint32_t count = 1 << 14;
        for (uint32_t i = 0; i < count; ++i) {
            const LightDraw draw = light.sample({0, 0, 0}, owen_sobol(i, 5));
            const ExactLight seen = light.exact({{0, 0, 0}, {0, 0, 1}, draw.d, 0});
            EXPECT_NEAR(seen.pdf, draw.pdf, 1e-3f * draw.pdf);
            sum += seen.radiance.x / 2 * draw.d.z / draw.pdf / count;
        }
        EXPECT_NEAR(sum, lambert(corners), 2e-3 * lambert(corners));
    }
}

TEST(AreaLight, DrawsHaveTheDensityTheyClaim) {
    for (const Image& image : {Image(), picture()}) {
        const AreaLight light(settings_of(kSquare), Color3f(1), image);
        const Vec3f p(0.8f, -0.3f, 1.2f), u = kSquare[1] - kSquare[0], v = kSquare[3] - kSquare[0];
        uint32_t index = 0;
        const auto draw = [&]() -> std::optional<SquarePoint> {
            const LightDraw drawn = light.sample(p, owen_sobol(index++, 9));
            const Vec3f place = p + drawn.d * ((2 - p.z) / drawn.d.z) - kSquare[0];
            return SquarePoint{place.dot(u) / u.length2(), place.dot(v) / v.length2()};
        };
        const auto density = [&](const SquarePoint& at) {
            const Vec3f way = kSquare[0] + u * static_cast<float>(at.a) + v * static_cast<float>(at.b) - p;
            const float r2 = way.length2(), area = u.length() * v.length();
            return static_cast<double>(light.exact({p, {0, 0, 1}, way.normalized(), 0}).pdf * area * way.z /
                                       (r2 * std::sqrt(r2)));
        };
        const ChiSquare result = chi_square(1 << 15, 12, draw, density);
        EXPECT_GT(result.p_value, 1e-4);
        EXPECT_NEAR(result.mass, 1, 0.01);
    }
}

TEST(AreaLight, NodesHoldItsPower) {
    for (const auto& corners : {kSquare, kTriangle, kPentagon}) {
        std::vector<AreaNode> own;
        const AreaLight light(settings_of(corners, true));
        float sum = 0;
        for (const AreaNode& node : light.nodes_above({0, 0, 0}, {0, 0, 1}, own)) sum += node.power.x;
        EXPECT_NEAR(sum, 2 * light.polygon().area, 1e-4f * sum);
    }
}

TEST(AreaLight, RefusesWhatIsNoPolygon) {
    const std::vector<std::vector<Vec3f>> bad{{{0, 0, 0}, {1, 0, 0}},
                                              {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                              {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 1, 0}},
                                              {{0, 0, 0}, {1, 0, 0}, {0.2f, 0.2f, 0}, {0, 1, 0}},
                                              {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                              {{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}};
    for (const auto& corners : bad) EXPECT_THROW(AreaLight{settings_of(corners)}, Error);
    EXPECT_THROW(AreaLight(settings_of(kTriangle), Color3f(1), picture()), Error);
    EXPECT_THROW(AreaLight(settings_of(kSquare), Color3f(-1)), Error);
}
