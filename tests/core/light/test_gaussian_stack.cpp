#include "light_pictures.h"

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/light/environment.h>
#include <burnish/light/filter/gaussian_stack.h>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

using namespace burnish_test;

namespace {

/// Legendre coefficients 1 and 2 of the spherical Gaussian: how much it leaves of light of these orders.
double damping(int order, double sigma) {
    const double k = 1.0 / (sigma * sigma), first = 1.0 / std::tanh(k) - 1.0 / k;
    return order == 1 ? first : 1.0 - 3.0 * first / k;
}

double gaussian(double versine, double sigma) {
    const double k = 1.0 / (sigma * sigma);
    return k / (2 * std::numbers::pi * -std::expm1(-2 * k)) * std::exp(-versine * k);
}

/// Light of one texel of face 2, 1 in total.
std::array<Image, 6> one_texel(int size, int x, int y) {
    auto faces = constant_faces(size, {0, 0, 0});
    faces[2].at(x, y)[1] = static_cast<float>(1.0 / texel_solid_angle(x, y, size));
    return faces;
}

/// What a level's lookups make of a texel's light, compared with the Gaussian around it.
struct Response {
    double error = 0;     // largest difference, relative to the Gaussian's peak
    double energy = 0;    // the integral; 1 when kept
    double versine = 0;   // mean, of what was found
    double expected = 0;  // that of the level's sigma
};

Response response(const GaussianStack& stack, const Vec3f& centre, float level) {
    constexpr int count = 20000;
    const double sigma = stack.sigma(level), widest = std::min(2.0, 9.0 * sigma * sigma);
    const double area = 2 * std::numbers::pi * widest / count;
    const Frame frame = Frame::around(centre);
    Response r;
    for (int i = 0; i < count; ++i) {
        const double versine = widest * (i + 0.5) / count, side = std::sqrt(versine * (2 - versine)), phi = 2.399963 * i;
        const Vec3f local(static_cast<float>(side * std::cos(phi)), static_cast<float>(side * std::sin(phi)),
                          static_cast<float>(1 - versine));
        const double found = stack.stack().lookup(frame.to_world(local), level).y;
        r.error = std::max(r.error, std::fabs(found - gaussian(versine, sigma)) / gaussian(0, sigma));
        r.energy += found * area;
        r.versine += found * area * versine;
    }
    r.versine /= r.energy;
    r.expected = 1.0 - damping(1, sigma);
    return r;
}

Color3f stripes(const Vec3f& d) { return {1 + std::sin(9 * d.x), std::exp(3.0f * d.y), d.z > 0.3f ? 5.0f : 0.1f}; }

/// Legendre polynomials of z about an oblique axis, in red (order 1) and green (order 2).
Color3f harmonics(const Vec3f& d) {
    const float z = d.dot(Vec3f(0.36f, 0.48f, 0.8f));
    return {z, 1.5f * z * z - 0.5f, 0.0f};
}

}  // namespace

TEST(GaussianStack, WidthsGrowEvenlyOnTexelsThatHoldThem) {
    const GaussianStack stack(constant_faces(256, {1, 1, 1}));
    EXPECT_NEAR(stack.sigma(1.0f), 2.0f / 256, 1e-6f);
    for (int level = 2; level < stack.stack().level_count(); ++level) {
        const float sigma = stack.sigma(static_cast<float>(level)), narrower = stack.sigma(static_cast<float>(level - 1));
        const bool dense = narrower > 0.028f;
        EXPECT_NEAR(sigma / narrower, dense ? std::pow(2.0, 0.25) : std::numbers::sqrt2, 1e-3) << level;
        EXPECT_LE(2.0f / static_cast<float>(stack.stack()[level].size()), (dense ? 0.501f : 0.751f) * sigma) << level;
    }
    EXPECT_GT(stack.sigma(100.0f), 0.99f);
}

TEST(GaussianStack, LevelAndSigmaAreInverse) {
    const GaussianStack stack(constant_faces(64, {1, 1, 1}));
    for (float level = 0; level <= static_cast<float>(stack.stack().level_count() - 1); level += 0.125f)
        EXPECT_NEAR(stack.level(stack.sigma(level)), level, 1e-3f);
    const float nan = std::nanf("");
    EXPECT_EQ(stack.level(0.0f), 0.0f);
    EXPECT_EQ(stack.level(-1.0f), 0.0f);
    EXPECT_EQ(stack.level(nan), 0.0f);
    EXPECT_EQ(stack.level(1e-20f), 0.0f);
    EXPECT_EQ(stack.level(INFINITY), static_cast<float>(stack.stack().level_count() - 1));
}

TEST(GaussianStack, KeepsAConstantAtEveryWidth) {
    const GaussianStack stack(constant_faces(96, {0.25f, 1.0f, 3.0f}));
    Directions random;
    for (int i = 0; i < 20000; ++i) {
        const Color3f c = stack.stack().lookup(random.next(), stack.level(1.1f * random.uniform() * random.uniform()));
        ASSERT_NEAR(c.x, 0.25f, 0.25e-5f);
        ASSERT_NEAR(c.y, 1.0f, 1e-5f);
        ASSERT_NEAR(c.z, 3.0f, 3e-5f);
    }
}

TEST(GaussianStack, KeepsTheEnergyOfAPicture) {
    const GaussianStack stack(painted_faces(128, stripes));
    const double given = level_energy(stack.stack(), 0);
    for (int level = 1; level < stack.stack().level_count(); ++level)
        EXPECT_NEAR(level_energy(stack.stack(), level) / given, 1.0, 1e-3) << level;
}

TEST(GaussianStack, DampsSphericalHarmonicsLikeTheGaussian) {
    const GaussianStack stack(painted_faces(128, harmonics));
    Directions random;
    for (float level = 2; level <= static_cast<float>(stack.stack().level_count() - 1); level += 0.5f) {
        const double sigma = stack.sigma(level);
        for (int i = 0; i < 2000; ++i) {
            const Vec3f d = random.next();
            const Color3f given = harmonics(d), found = stack.stack().lookup(d, level);
            ASSERT_NEAR(found.x, damping(1, sigma) * given.x, 0.015) << level;
            ASSERT_NEAR(found.y, damping(2, sigma) * given.y, 0.02) << level;
        }
    }
}

TEST(GaussianStack, ATexelBecomesTheGaussianWhereverItIs) {
    const int n = 128;
    for (const auto& [x, y] : {std::array{n / 2, n / 2}, {0, n / 2}, {0, 0}, {n / 4, n / 8}}) {
        const GaussianStack stack(one_texel(n, x, y));
        const Vec3f centre = cube_direction(2, (x + 0.5f) / n, (y + 0.5f) / n);
        for (float level = 7; level <= static_cast<float>(stack.stack().level_count() - 1); level += 0.5f) {
            const Response r = response(stack, centre, level);
            EXPECT_LT(r.error, 0.09) << x << " " << y << " level " << level;
            EXPECT_NEAR(r.energy, 1.0, 0.03) << x << " " << y << " level " << level;
            EXPECT_NEAR(std::sqrt(r.versine / r.expected), 1.0, 0.01) << x << " " << y << " level " << level;
        }
    }
}

TEST(GaussianStack, IsContinuousAcrossEdgesAndCorners) {
    const GaussianStack stack(painted_faces(32, stripes));
    Directions random(3);
    for (int i = 0; i < 20000; ++i) {
        Vec3f edge = random.next();
        edge.x = std::copysign(std::max({std::fabs(edge.x), std::fabs(edge.y), std::fabs(edge.z)}), edge.x);
        edge.y = std::copysign(std::fabs(edge.x), edge.y);
        if (i % 2) edge.z = std::copysign(std::fabs(edge.x), edge.z);
        const float level = 1.0f + 8.0f * random.uniform();
        const Vec3f step(1e-6f, -1e-6f, 1e-6f);
        const Color3f one = stack.stack().lookup((edge + step).normalized(), level);
        const Color3f other = stack.stack().lookup((edge - step).normalized(), level);
        ASSERT_LT((one - other).length(), 2e-3f) << edge << " level " << level;
    }
}

TEST(GaussianStack, IsTheSameForAnyThreadCount) {
    const auto faces = painted_faces(64, stripes);
    const auto build = [&](int threads) {
        const ThreadLimit limit(threads);
        return GaussianStack(faces);
    };
    const GaussianStack one = build(1), many = build(0);
    Directions random;
    for (int i = 0; i < 10000; ++i) {
        const Vec3f d = random.next();
        const float level = 12.0f * random.uniform();
        ASSERT_EQ(one.stack().lookup(d, level), many.stack().lookup(d, level));
    }
}

TEST(GaussianStack, MakesTheSameLevelsWhateverIsAskedForFirst) {
    const auto faces = painted_faces(256, stripes);
    const GaussianStack whole(faces), by_level(faces);
    const CubeStack& all = whole.stack();
    const auto expect_same = [&](float level) {
        Directions random;
        for (int i = 0; i < 200; ++i) {
            const Vec3f d = random.next();
            const CubeStack& read = by_level.stack(std::array{LevelRange{level, level}});
            ASSERT_EQ(read.lookup_rgba(d, level), all.lookup_rgba(d, level)) << level;
        }
    };
    expect_same(by_level.last_level());
    expect_same(12.5f);
    EXPECT_FALSE(by_level.is_filtered(0) || by_level.is_filtered(1)) << "a wide level needs nothing of the fine ones";
    for (const float level : {1.5f, 0.0f, 3.0f}) expect_same(level);
    EXPECT_FALSE(by_level.is_filtered(8));
    for (float level = 0.25f; level <= by_level.last_level(); ++level) expect_same(level);
}

TEST(GaussianStack, IsReadByAnyThreadWhileOthersAskForMore) {
    const auto faces = painted_faces(64, stripes);
    const GaussianStack whole(faces), shared(faces);
    const CubeStack& all = whole.stack();
    std::atomic<int> wrong = 0;
    const auto read = [&](int first) {
        for (int i = 0; i < shared.level_count(); ++i) {
            const auto level = static_cast<float>((i * 5 + first) % shared.level_count());
            const CubeStack& part = shared.stack(std::array{LevelRange{level, level}});
            Directions random(static_cast<unsigned>(i));
            for (int k = 0; k < 50; ++k)
                if (const Vec3f d = random.next(); part.lookup(d, level) != all.lookup(d, level)) ++wrong;
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back(read, 3 * i);
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

/// Sums over the shrunk map start afresh, so that what blurs of blurs miss is not passed on.
TEST(GaussianStack, IsNearTheGaussianWhereItStartsAfresh) {
    const int n = 256;
    const GaussianStack stack(one_texel(n, n / 4, n / 8));
    const Vec3f centre = cube_direction(2, (n / 4 + 0.5f) / n, (n / 8 + 0.5f) / n);
    const float level = std::round(stack.level(0.0625f));
    ASSERT_NEAR(stack.sigma(level), 0.0625, 1e-6);
    const Response r = response(stack, centre, level);
    EXPECT_LT(r.error, 0.06);  // 0.04 of it as the texel lies off the middle of the shrunk map's
    EXPECT_NEAR(r.energy, 1.0, 0.01);
}

TEST(GaussianStack, TakesFacesOfAnySize) {
    for (const int size : {1, 2, 3, 4, 7, 8, 16, 20}) {
        const GaussianStack stack(constant_faces(size, {1, 2, 3}));
        Directions random;
        for (int i = 0; i < 500; ++i) {
            const Color3f c = stack.stack().lookup(random.next(), stack.level(1.2f * random.uniform()));
            ASSERT_LT((c - Color3f(1, 2, 3)).length(), 1e-4f) << size;
        }
    }
    EXPECT_EQ(GaussianStack(constant_faces(1, {1, 1, 1})).stack().level_count(), 1);
    EXPECT_THROW(GaussianStack(std::array<Image, 6>{}), Error);
    auto faces = constant_faces(8, {1, 1, 1});
    faces[4] = Image(8, 4, 3);
    EXPECT_THROW(GaussianStack{faces}, Error);
}

TEST(GaussianStack, OfAnEnvironmentIsMadeOnceWhoeverAsksFirst) {
    const Environment light = Environment::from_image(Image(64, 32, 3), {}, "black");
    std::array<const GaussianStack*, 4> found;
    std::vector<std::thread> threads;
    for (auto& stack : found) threads.emplace_back([&] { stack = &light.gaussian_stack(); });
    for (std::thread& thread : threads) thread.join();
    for (const GaussianStack* stack : found) EXPECT_EQ(stack, found[0]);
    EXPECT_EQ(found[0]->stack()[0].size(), light.face_size());
    std::atomic<int> levels = 0;
    for_each_index(64, [&](int) { levels += light.pyramid().level_count(); });
    EXPECT_EQ(levels, 64 * light.pyramid().level_count());
}
