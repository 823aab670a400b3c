// The far tail of a lobe: lamps off the mirror direction, which a few fitted Gaussians do not reach.
#include "shading_cases.h"

#include <burnish/shading/lobe_taps.h>
#include <burnish/shading/local_shading.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

constexpr float kLampRadius = 0.3f, kLampRadiance = 100;

/// A round lamp in the dark around d.
Environment lamp(const Vec3f& d) {
    Image image(256, 128, 3);
    const Matrix33f to_world = light_of(image).world_to_light().transposed();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float theta = kPi * (y + 0.5f) / 128,
                        phi = kPi * (128 - x - 0.5f) / 128;  // openexr.com, latitude-longitude maps
            const Vec3f at(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            if ((at * to_world).dot(d) > std::cos(kLampRadius)) std::fill_n(image.at(x, y), 3, kLampRadiance);
        }
    EnvironmentSettings settings;
    settings.suns = Suns::keep, settings.face_size = 64;
    return Environment::from_image(image, settings, "lamp");
}

/// The lobe's integral over the lamp.
float reflected_lamp(const LobeParameters& p, const Vec3f& d, const Vec3f& wo) {
    const Frame frame = Frame::around(d);
    return visit_lobe(p, [&](const auto& own) {
        double sum = 0;
        for (int i = 0; i < 4096; ++i) {
            const float z = 1 - (1 - std::cos(kLampRadius)) * (static_cast<float>(i) + 0.5f) / 4096, r = std::sqrt(1 - z * z);
            const Vec3f wi = frame.to_world({r * std::cos(2.4f * i), r * std::sin(2.4f * i), z});
            sum += own.eval(wo, wi).x * wi.z;
        }
        return static_cast<float>(sum / 4096 * kLampRadiance * 2 * kPi * (1 - std::cos(kLampRadius)));
    });
}

SurfaceBatch seen_from(const Vec3f& wo) {
    SurfaceBatch batch;
    batch.pixel.push_back(0);
    batch.p.push_back({0, 0, 0}), batch.n.push_back({0, 0, 1}), batch.t.push_back({1, 0, 0}), batch.wo.push_back(wo);
    return batch;
}

float overlay(const LobeTaps& taps, const Environment& light, const SurfaceBatch& batch) {
    const LightChain chain(
        {{std::make_shared<const Light>(EnvironmentLight(std::make_shared<const Environment>(light))), false}});
    std::vector<Color3f> sum(1, Color3f(0));
    std::vector<float> samples(1), error(1);
    add_local_lobe(taps, chain, batch, {sum, samples, error});
    return sum[0].x;
}

}  // namespace

TEST(TailTaps, AreForSharpLobesWithLongTails) {
    EXPECT_EQ(TailTaps(lobe(ModelId::beckmann, 0.02f, 0.02f)).count(), 0);
    EXPECT_EQ(TailTaps(lobe(ModelId::ggx, 0.2f, 0.2f)).count(), 0) << "beyond six widths there is no sky";
    EXPECT_EQ(TailTaps(lobe(ModelId::ggx, 0.05f, 0.05f)).count(), 0) << "fits reach as far";
    EXPECT_EQ(TailTaps(lobe(ModelId::ggx, 0.03f, 0.03f)).count(), 5);
    EXPECT_EQ(TailTaps(lobe(ModelId::ggx, 0.02f, 0.02f)).count(), 10);
}

TEST(TailTaps, FollowNoMoreThanTenFittedOnes) {
    const LobeTaps taps(lobe(ModelId::ggx, 0.02f, 0.02f), estimator(EstimatorKind::fitted, 16));
    EXPECT_EQ(taps.table()->tap_count(), 10 + 10);
}

TEST(TailTaps, KeepTheLobesEnergy) {
    for (const EstimatorKind kind : {EstimatorKind::fitted, EstimatorKind::regular}) {
        const LobeParameters ggx = lobe(ModelId::ggx, 0.02f, 0.02f);
        const LobeTaps with(ggx, estimator(kind, 6)), without(ggx, estimator(kind, 6), false);
        EXPECT_EQ(with.table()->tap_count(), without.table()->tap_count() + 10);
        for (const float cosine : {0.95f, 0.5f, 0.2f}) {
            const ShadingPoint point =
                shading_point(seen_from({std::sqrt(1 - cosine * cosine), 0, cosine}), 0, ggx, Matrix33f());
            float sum[2] = {0, 0};
            std::vector<Tap> taps;
            for (const LobeTaps* one : {&with, &without}) {
                one->at(point, taps);
                for (const Tap& tap : taps) sum[one == &with] += tap.weight.x;
            }
            EXPECT_NEAR(sum[1], sum[0], 2e-3f * sum[0]) << cosine;
        }
    }
}

TEST(TailTaps, SeeLampsFarOff) {
    const LobeParameters ggx = lobe(ModelId::ggx, 0.02f, 0.02f);
    const LobeTaps with(ggx, estimator(EstimatorKind::fitted, 6)), without(ggx, estimator(EstimatorKind::fitted, 6), false);
    const Vec3f wo(-std::sin(0.7f), 0, std::cos(0.7f));
    const Frame mirror = Frame::along(Vec3f(-wo.x, 0, wo.z), {0, 1, 0});
    for (const float away : {0.6f, 0.8f, 1.0f}) {
        float found = 0, found_without = 0, truth = 0;
        for (int k = 0; k < 8; ++k) {
            const float phi = 2 * kPi * static_cast<float>(k) / 8;
            const Vec3f d = mirror.to_world({std::sin(away) * std::cos(phi), std::sin(away) * std::sin(phi), std::cos(away)});
            if (d.z < kLampRadius) continue;
            const Environment light = lamp(d);
            found += overlay(with, light, seen_from(wo)), found_without += overlay(without, light, seen_from(wo));
            truth += reflected_lamp(ggx, d, wo);
        }
        EXPECT_LT(found_without, 0.3f * truth) << away;
        EXPECT_GT(found, 0.65f * truth) << away;
        EXPECT_LT(found, 1.5f * truth) << away;
    }
}
