#include "light_pictures.h"

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

constexpr PyramidKernel kKernels[] = {PyramidKernel::box2, PyramidKernel::binomial4, PyramidKernel::binomial6};

Color3f noise(const Vec3f& d) {
    static Directions random(7);
    const float sparkle = random.uniform();
    return {sparkle, 0.2f + d.x * d.x + sparkle, std::exp(3.0f * d.y)};
}

}  // namespace

TEST(CubeFaces, DirectionAndPlaceAreInverse) {
    Directions random;
    for (int i = 0; i < 100000; ++i) {
        const Vec3f d = random.next();
        const CubeCoord c = cube_coord(d);
        ASSERT_LT((cube_direction(c.face, c.x, c.y) - d).length(), 3e-7f);
    }
}

TEST(CubeFaces, FacesLookAsOpenExrSays) {
    const Vec3f forward[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Vec3f right[6] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}};
    const Vec3f top[6] = {{0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, 1, 0}};
    for (int face = 0; face < 6; ++face) {
        EXPECT_EQ(forward[face].cross(top[face]), right[face]) << "seen from inside, face " << face;
        const Vec3f d = forward[face] + right[face] * 0.5f + top[face] * 0.25f;
        const CubeCoord c = cube_coord(d);
        EXPECT_EQ(c.face, face);
        EXPECT_FLOAT_EQ(c.x, 0.75f);
        EXPECT_FLOAT_EQ(c.y, 0.375f);
    }
}

TEST(CubeFaces, UnfoldedTexelsAreNeighboursOnTheSphere) {
    const int n = 8;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < n; ++i) {
            for (const auto& [x, y, inner_x, inner_y] :
                 {std::array{-1, i, 0, i}, {n, i, n - 1, i}, {i, -1, i, 0}, {i, n, i, n - 1}}) {
                const CubeTexel t = unfolded_texel(face, x, y, n);
                ASSERT_NE(t.face, face);
                const auto centre = [&](int f, int cx, int cy) { return cube_direction(f, (cx + 0.5f) / n, (cy + 0.5f) / n); };
                EXPECT_LT((centre(t.face, t.x, t.y) - centre(face, inner_x, inner_y)).length(), 2.0f / n);
            }
        }
    }
}

TEST(CubeFaces, SolidAnglesCoverTheSphere) { EXPECT_NEAR(6 * cube_solid_angle(-1, 1, -1, 1), 4 * std::numbers::pi, 1e-12); }

TEST(CubePyramid, IsContinuousAcrossEdgesAndCorners) {
    const CubePyramid pyramid(painted_faces(16, noise), PyramidKernel::binomial6);
    Directions random(3);
    for (int i = 0; i < 20000; ++i) {
        Vec3f edge = random.next();
        edge.x = std::copysign(std::max({std::fabs(edge.x), std::fabs(edge.y), std::fabs(edge.z)}), edge.x);
        edge.y = std::copysign(std::fabs(edge.x), edge.y);
        if (i % 2) edge.z = std::copysign(std::fabs(edge.x), edge.z);
        const float level = 4.0f * random.uniform();
        const Color3f one = pyramid.lookup((edge + Vec3f(1e-6f, -1e-6f, 1e-6f)).normalized(), level);
        const Color3f other = pyramid.lookup((edge - Vec3f(1e-6f, -1e-6f, 1e-6f)).normalized(), level);
        ASSERT_LT((one - other).length(), 2e-3f) << edge << " level " << level;
    }
}

TEST(CubePyramid, KeepsAConstantAtEveryLevel) {
    for (const PyramidKernel kernel : kKernels) {
        const CubePyramid pyramid(constant_faces(64, {0.25f, 1.0f, 3.0f}), kernel);
        ASSERT_EQ(pyramid.level_count(), 7);
        Directions random;
        for (int i = 0; i < 10000; ++i) {
            const Color3f c = pyramid.lookup(random.next(), 7.0f * random.uniform() - 0.5f);
            ASSERT_NEAR(c.x, 0.25f, 1e-6f);
            ASSERT_NEAR(c.y, 1.0f, 2e-6f);
            ASSERT_NEAR(c.z, 3.0f, 6e-6f);
        }
    }
}

TEST(CubePyramid, KeepsEnergyAtEveryLevel) {
    for (const PyramidKernel kernel : kKernels) {
        const CubePyramid pyramid(painted_faces(128, noise), kernel);
        for (int level = 1; level < pyramid.level_count(); ++level) {
            EXPECT_NEAR(level_energy(pyramid.stack(), level) / level_energy(pyramid.stack(), 0), 1.0, 1e-6)
                << "level " << level;
        }
    }
}

TEST(CubePyramid, KeepsTheEnergyOfASingleTexelWhereverItIs) {
    const int n = 128;
    double worst[3] = {0, 0, 0};
    for (const auto& [x, y] : {std::array{0, 0}, {1, 1}, {0, 63}, {1, 40}, {63, 63}, {126, 127}}) {
        auto faces = constant_faces(n, {0, 0, 0});
        faces[3].at(x, y)[1] = 1000.0f;
        for (int k = 0; k < 3; ++k) {
            const CubePyramid pyramid(faces, kKernels[k]);
            for (int level = 1; level < pyramid.level_count(); ++level) {
                worst[k] = std::max(worst[k],
                                    std::fabs(level_energy(pyramid.stack(), level) / level_energy(pyramid.stack(), 0) - 1.0));
            }
        }
    }
    RecordProperty("worst_box2", std::to_string(worst[0]));
    RecordProperty("worst_binomial6", std::to_string(worst[2]));
    EXPECT_LT(worst[0], 1e-6);
    EXPECT_LT(worst[1], 5e-4);
    EXPECT_LT(worst[2], 5e-4);
}

TEST(CubePyramid, BoxLevelsAreTheSolidAngleMeanOfTheirTexels) {
    const auto faces = painted_faces(32, noise);
    const CubePyramid pyramid(faces, PyramidKernel::box2);
    const int level = 3, block = 1 << level;
    for (int face = 0; face < 6; ++face) {
        double sum = 0, omega = 0;
        for (int y = 0; y < block; ++y) {
            for (int x = 0; x < block; ++x) {
                const double o = texel_solid_angle(x + block, y, 32);
                sum += o * faces[face].at(x + block, y)[2];
                omega += o;
            }
        }
        EXPECT_NEAR(pyramid.texel(level, face, 1, 0).z, sum / omega, 1e-5 * sum / omega);
    }
}

TEST(CubePyramid, BinomialLevelsFollowASmoothPictureAcrossFaces) {
    // A linear function of direction has no bandwidth to lose: fine levels reproduce it up to the kernel's blur.
    const CubePyramid pyramid(painted_faces(128, [](const Vec3f& d) { return Color3f(2 + d.x, 2 + d.y, 2 + d.z); }),
                              PyramidKernel::binomial6);
    Directions random;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f d = random.next();
        const Color3f c = pyramid.lookup(d, 2.0f);
        ASSERT_LT((Vec3f(c) - (Vec3f(2.0f) + d)).length(), 1e-2f) << d;
    }
}

TEST(CubePyramid, LevelIsZeroForOneTexelAndOneMoreForFour) {
    const int n = 64;
    const CubePyramid pyramid(constant_faces(n, {1, 1, 1}), PyramidKernel::box2);
    for (const auto& [x, y] : {std::array{32, 32}, {0, 0}, {5, 50}}) {
        const Vec3f d = cube_direction(2, (x + 0.5f) / n, (y + 0.5f) / n);
        const auto omega = static_cast<float>(texel_solid_angle(x, y, n));
        EXPECT_NEAR(pyramid.level(d, omega), 0.0f, 2e-3f);
        EXPECT_NEAR(pyramid.level(d * 3.0f, 4 * omega), 1.0f, 2e-3f);
    }
}

TEST(CubePyramid, LookupSurvivesAnyInput) {
    const CubePyramid pyramid(constant_faces(8, {1, 1, 1}), PyramidKernel::binomial4);
    const float nan = std::nanf(""), inf = INFINITY;
    for (const Vec3f& d :
         {Vec3f(0, 0, 0), Vec3f(nan, 0, 1), Vec3f(nan, nan, nan), Vec3f(inf, inf, 1), Vec3f(1, 1, 1), Vec3f(-1, -1, 1)}) {
        for (const float level : {0.0f, -5.0f, 50.0f, nan, inf, -inf, 2.999f, 3.0f}) {
            EXPECT_NEAR(pyramid.lookup(d, level).x, 1.0f, 1e-5f) << d << " level " << level;
        }
    }
}

TEST(CubePyramid, ASingleTexelPerFaceWorks) {
    auto faces = constant_faces(1, {0, 0, 0});
    faces[0].at(0, 0)[0] = 1.0f;
    const CubePyramid pyramid(faces, PyramidKernel::binomial6);
    EXPECT_EQ(pyramid.level_count(), 1);
    EXPECT_FLOAT_EQ(pyramid.lookup({1, 0, 0}, 0).x, 1.0f);
    EXPECT_FLOAT_EQ(pyramid.lookup({0, 1, 0}, 0).x, 0.0f);
    EXPECT_NEAR(pyramid.lookup(Vec3f(1, 1, 1).normalized(), 0).x, 1.0f / 3.0f, 1e-6f);
    EXPECT_NEAR(pyramid.lookup(Vec3f(1, 0, 1).normalized(), 0).x, 0.5f, 1e-6f);
}

TEST(CubePyramid, IsTheSameForAnyThreadCount) {
    const auto faces = painted_faces(64, noise);
    const auto build = [&](int threads) {
        const ThreadLimit limit(threads);
        return CubePyramid(faces, PyramidKernel::binomial6);
    };
    const CubePyramid one = build(1), many = build(0);
    Directions random;
    for (int i = 0; i < 10000; ++i) {
        const Vec3f d = random.next();
        const float level = 6.0f * random.uniform();
        ASSERT_EQ(one.lookup(d, level), many.lookup(d, level));
    }
}

TEST(CubePyramid, RefusesFacesThatAreNotPowersOfTwo) {
    EXPECT_THROW(CubePyramid(constant_faces(12, {1, 1, 1}), PyramidKernel::box2), Error);
    auto faces = constant_faces(8, {1, 1, 1});
    faces[4] = Image(4, 4, 3);
    EXPECT_THROW(CubePyramid(faces, PyramidKernel::box2), Error);
}
