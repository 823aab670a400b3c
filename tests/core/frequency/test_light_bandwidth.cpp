#include "core/light/light_pictures.h"

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/frequency/light_bandwidth.h>
#include <burnish/light/environment.h>
#include <burnish/light/latlong.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace burnish_test;

namespace {

const Vec3f kAxis = Vec3f(0.36f, 0.48f, 0.8f);

/// `cycles` a radian around the axis' equator, fewer towards its poles.
Color3f waves(const Vec3f& d, float cycles) { return Color3f(1.0f + 0.5f * std::sin(2 * kPi * cycles * d.dot(kAxis))); }

float wave_frequency(const Vec3f& d, float cycles) {
    const float along = d.dot(kAxis);
    return cycles * std::sqrt(1 - along * along);
}

/// Distance to the nearest edge of the cube, in face widths.
float edge_distance(const Vec3f& d) {
    const CubeCoord c = cube_coord(d);
    return std::min({c.x, c.y, 1 - c.x, 1 - c.y});
}

/// A room of patches, bright and dark, some with fine detail.
Color3f patches(const Vec3f& d) {
    const float a = std::sin(5 * d.x + 1) * std::sin(7 * d.y) > 0.2f ? 4.0f : 0.5f;
    return Color3f(a * (d.z > 0.3f ? 1 + 0.3f * std::sin(60 * d.x) * std::sin(50 * d.y) : 1.0f));
}

float median(std::vector<float> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

}  // namespace

TEST(LightBandwidth, ConstantLightHasNone) {
    const LightBandwidth light(constant_faces(128, {2, 2, 2}), {});
    Directions random;
    for (int i = 0; i < 5000; ++i) ASSERT_LT(light.at(random.next(), 0.5f * random.uniform()), 0.01f);
}

TEST(LightBandwidth, WavesHaveTheirOwnFrequencyAcrossSeams) {
    for (const float cycles : {4.0f, 10.0f, 25.0f}) {
        const LightBandwidth light(painted_faces(256, [&](const Vec3f& d) { return waves(d, cycles); }), {});
        Directions random;
        float at_edges = 0, elsewhere = 0;
        std::vector<float> octaves;
        for (int i = 0; i < 20000; ++i) {
            const Vec3f d = random.next();
            const float expected = wave_frequency(d, cycles);
            if (expected < 2) continue;
            const float ratio = light.at(d, 0.0f) / expected;
            octaves.push_back(std::log2(ratio));
            ASSERT_GT(ratio, 0.7f) << d;
            float& largest = edge_distance(d) < 0.02f ? at_edges : elsewhere;
            largest = std::max(largest, ratio);
        }
        EXPECT_NEAR(median(octaves), 0.6f, 0.4f) << cycles;  // half an octave, and the mapping's larger stretch
        EXPECT_LT(elsewhere, 5.0f) << cycles;
        EXPECT_LT(at_edges, 1.3f * elsewhere) << cycles;
    }
}

TEST(LightBandwidth, TurnsWithTheLight) {
    const Frame turned = Frame::around(Vec3f(0.48f, -0.6f, 0.64f)).turned(0.7f);
    const LightBandwidth straight(painted_faces(256, patches), {});
    const LightBandwidth oblique(painted_faces(256, [&](const Vec3f& d) { return patches(turned.to_local(d)); }), {});
    Directions random;
    for (const float radius : {0.1f, 0.2f, 0.4f}) {
        int far = 0;
        std::vector<float> octaves;
        for (int i = 0; i < 5000; ++i) {
            const Vec3f d = random.next();
            octaves.push_back(std::log2((straight.at(d, radius) + 0.5f) / (oblique.at(turned.to_world(d), radius) + 0.5f)));
            far += std::fabs(octaves.back()) > 1;
        }
        EXPECT_NEAR(median(octaves), 0.0f, 0.2f) << radius;
        EXPECT_LT(far, 600) << radius;
    }
}

TEST(LightBandwidth, NoReadIsBelowWhatItsConeHolds) {
    const LightBandwidth light(painted_faces(128, patches), {});
    const CubeLevel& finest = light.maxima()[0];
    Directions random(4);
    for (int i = 0; i < 3000; ++i) {
        const Vec3f d = i % 3 ? random.next() : Vec3f(1, 1 - 0.01f * random.uniform(), random.uniform()).normalized();
        const float radius = 0.78f * random.uniform() * random.uniform(), found = light.at(d, radius);
        const Frame frame = Frame::around(d);
        for (int k = 0; k < 200; ++k) {
            const float angle = radius * std::sqrt(random.uniform()), phi = 2 * kPi * random.uniform();
            const Vec3f w = frame.to_world({std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)});
            const CubeCoord c = cube_coord(w);
            // A texel's own value is the smallest of the nine maxima that it takes part in.
            float own = INFINITY;
            const int x = std::min(127, static_cast<int>(128 * c.x)), y = std::min(127, static_cast<int>(128 * c.y));
            for (int n = 0; n < 9; ++n) own = std::min(own, *finest.at(c.face, x + n % 3 - 1, y + n / 3 - 1));
            ASSERT_GE(found, own * 0.9999f) << d << " " << w << " radius " << radius;
        }
    }
}

TEST(LightBandwidth, AWiderConeIsNeverLower) {
    const LightBandwidth light(painted_faces(128, patches), {});
    Directions random(8);
    for (int i = 0; i < 2000; ++i) {
        const Vec3f d = random.next();
        float before = 0;
        for (float radius = 0; radius < 0.78f; radius += 0.02f) {
            const float found = light.at(d, radius);
            ASSERT_GE(found, before * 0.9999f);
            before = found;
        }
    }
}

TEST(LightBandwidth, DiscsThatWereTakenOutCount) {
    const BrightDisc sun{
        Vec3f(0.6f, 0.64f, 0.48f), Vec3f(-0.8f, 0.48f, 0.36f) * 0.005f, Vec3f(0, -0.6f, 0.8f) * 0.005f, {1, 1, 1}};
    const auto sky = constant_faces(256, {1, 1, 1});
    const LightBandwidth without(sky, {}), with(sky, std::array{sun});
    EXPECT_LT(without.at(sun.direction, 0.1f), 0.01f);
    EXPECT_GT(with.at(sun.direction, 0.0f), 30.0f);
    const Vec3f aside = (sun.direction + sun.across * 20.0f).normalized();  // 0.1 rad
    EXPECT_LT(with.at(aside, 0.0f), 0.5f * with.at(sun.direction, 0.0f));
    EXPECT_GT(with.at(aside, 0.12f), 30.0f);
    EXPECT_LT(with.at(-sun.direction, 0.3f), 0.01f);
}

TEST(LightBandwidth, OfAnEnvironmentKeepsItsDetail) {
    Image picture(512, 256, 3);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) {
            const Color3f c = waves(latlong_direction({(x + 0.5f) / 512, (y + 0.5f) / 256}), 8.0f);
            std::copy_n(&c.x, 3, picture.at(x, y));
        }
    }
    EnvironmentSettings settings;
    settings.convention = EnvironmentConvention::openexr;
    const Environment environment = Environment::from_image(picture, settings, "waves");
    const LightBandwidth light(environment);
    EXPECT_EQ(light.maxima()[0].size(), 128);
    Directions random;
    for (int i = 0; i < 2000; ++i) {
        const Vec3f d = random.next();
        if (wave_frequency(d, 8) > 4) ASSERT_GT(light.at(d, 0.0f), 0.7f * wave_frequency(d, 8));
    }
}

TEST(LightBandwidth, LargeFacesAreReducedAndBadOnesRefused) {
    const LightBandwidth light(painted_faces(512, patches), {});
    EXPECT_EQ(light.maxima()[0].size(), LightBandwidth::kLargestFace);
    EXPECT_EQ(light.maxima().level_count(), 10);
    EXPECT_THROW(LightBandwidth(constant_faces(24, {1, 1, 1}), {}), Error);
    auto uneven = constant_faces(32, {1, 1, 1});
    uneven[3] = Image(16, 16, 3);
    EXPECT_THROW(LightBandwidth(uneven, {}), Error);
    EXPECT_NEAR(LightBandwidth(constant_faces(1, {1, 1, 1}), {}).at({0, 0, 1}, 0.3f), 0.0f, 1e-5f);
}

TEST(LightBandwidth, IsTheSameForAnyThreadCount) {
    const auto faces = painted_faces(64, patches);
    const LightBandwidth many(faces, {});
    const ThreadLimit one(1);
    const LightBandwidth single(faces, {});
    Directions random;
    for (int i = 0; i < 1000; ++i) {
        const Vec3f d = random.next();
        ASSERT_EQ(many.at(d, 0.05f), single.at(d, 0.05f));
    }
}
