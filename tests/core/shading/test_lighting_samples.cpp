// Samples of what a material reflects of distant light, by normal and view.
#include <burnish/base/error.h>
#include <burnish/shading/lighting_samples.h>
#include "core/light/sun_pictures.h"
#include "shading_cases.h"

#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish_test;

namespace {

/// Brighter to one side and on top.
Image uneven_picture(int height) {
    Image picture(2 * height, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float phi = 2 * kPi * static_cast<float>(x) / static_cast<float>(picture.width);
            const Color3f value =
                Color3f(1, 0.8f, 0.5f) * (1 + 0.8f * std::sin(phi)) + Color3f(0, 0.2f, 0.5f) * (y < height / 2);
            std::copy_n(&value.x, 3, picture.at(x, y));
        }
    return picture;
}

LightingSampling few() {
    LightingSampling sampling;
    sampling.size = 8;
    return sampling;
}

TEST(LightingSamples, AreWhatTheMaterialReflects) {
    const Environment light = light_of(uneven_picture(64));
    const LobeParameters ggx = lobe(ModelId::ggx, 0.3f, 0.3f);
    const Matrix33f light_to_world = light.world_to_light().transposed();
    const std::vector<FactorSample> samples = lighting_samples(material(ggx), light, few());
    ASSERT_GT(samples.size(), 1000u);
    for (size_t i = 17; i < samples.size(); i += samples.size() / 8) {
        const auto& [pair, value, weight] = samples[i];
        const Vec3f n = pair.a * light_to_world, wo = pair.b * light_to_world;
        SurfaceBatch batch;
        batch.pixel.push_back(0);
        batch.n.push_back(n), batch.wo.push_back(wo), batch.p.push_back({0, 0, 0}), batch.t.push_back(Frame::around(n).t);
        const Color3f exact = shade(material(ggx), light, estimator(EstimatorKind::reference, 0), batch).overlay[0];
        EXPECT_NEAR(luminance(value) / luminance(exact), 1, 0.05f) << pair.a.dot(pair.b);
    }
}

TEST(LightingSamples, LookFromInFrontAndAreDrawnAsTheyAreSeen) {
    const Environment light = light_of(uneven_picture(32));
    double sum = 0;
    const std::vector<FactorSample> samples = lighting_samples(material(lobe(ModelId::ggx, 0.3f, 0.3f)), light, few());
    for (const FactorSample& sample : samples) {
        EXPECT_GT(sample.pair.a.dot(sample.pair.b), 0);
        sum += sample.weight;
    }
    EXPECT_NEAR(sum / static_cast<double>(samples.size()), 1, 1e-4);
    LightingSampling uniform = few();
    uniform.weight = ViewWeight::uniform;
    for (const FactorSample& sample : lighting_samples(material(lobe(ModelId::ggx, 0.3f, 0.3f)), light, uniform))
        EXPECT_FLOAT_EQ(sample.weight, 1);
}

TEST(LightingSamples, DoNotKnowHowTheLightIsTurnedOrScaled) {
    const Environment light = light_of(uneven_picture(32));
    EnvironmentSettings settings = light.settings();
    settings.rotate_deg = 70, settings.flip = true, settings.scale = 3, settings.tint = Color3f(1, 0.5f, 0.2f);
    const Material ggx = material(lobe(ModelId::ggx, 0.3f, 0.3f));
    const auto straight = lighting_samples(ggx, light, few()), turned = lighting_samples(ggx, light.relit(settings), few());
    ASSERT_EQ(straight.size(), turned.size());
    for (size_t i = 0; i < straight.size(); ++i) EXPECT_EQ(straight[i].value, turned[i].value);
}

TEST(LightingSamples, RefuseWhatDependsOnMore) {
    const Environment light = light_of(uneven_picture(16));
    EXPECT_THROW(lighting_samples(material(lobe(ModelId::ggx, 0.3f, 0.1f)), light, few()), Error);
    LobeParameters layered = lobe(ModelId::ggx, 0.3f, 0.3f);
    layered.per_pixel.roughness = true;
    EXPECT_THROW(lighting_samples(material(layered), light, few()), Error);
}

TEST(LightingSamples, StopWhenAsked) {
    const Environment light = light_of(uneven_picture(16));
    const Progress stop([](const std::string&, float done) { return done < 0.5f; });
    try {
        lighting_samples(material(lobe(ModelId::ggx, 0.3f, 0.3f)), light, few(), stop);
        FAIL() << "expected cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
}

TEST(DominantDirection, PointsToTheSun) {
    const PaintedSun sun{Vec3f(1, 2, -0.5f).normalized(), 1.0f};
    const Environment light = light_of(sunny_latlong({sun}, 128));
    EXPECT_GT(dominant_direction(light).dot(sun.direction), 0.99f);
}

TEST(DominantDirection, IsSomeDirectionWhereLightComesFromEverywhere) {
    Image white(64, 32, 3);
    std::fill(white.data.begin(), white.data.end(), 1.0f);
    EXPECT_NEAR(dominant_direction(light_of(white)).length(), 1, 1e-5f);
}

}  // namespace
