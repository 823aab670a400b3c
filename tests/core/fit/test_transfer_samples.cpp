#include <burnish/fit/search/diffuse_mode.h>
#include <burnish/fit/search/retro_reflection.h>
#include <burnish/fit/search/table_noise.h>
#include <burnish/fit/search/transfer_samples.h>
#include <burnish/material/albedo.h>
#include <gtest/gtest.h>

#include "synthetic_table.h"

namespace burnish::testing {
namespace {

const GonioGrid kGrid{{0, 20, 50, 65}, {0, 45}, 5};

Material one_lobe(float kd, float ks = 0.9f) {
    Material material;
    material.kd = Color3f(kd);
    material.lobes = {kurt_lobe(ks, 0.11f, 0.072f, 0.89f, 0.43f)};
    return material;
}

TEST(TransferSamples, WeighAsTheSourceDoes) {
    const Vec3f wo = direction(60, 30), wi = direction(20, 0);
    const std::vector<BrdfSample> pairs{
        {wo, wi, Color3f(0.5f)}, {direction(30, 0), wi, Color3f(0.2f)}, {direction(40, 0), wi, Color3f(0)}};
    const TransferSamples samples = transfer_samples(pairs, Side::reflection);
    ASSERT_EQ(samples.size(), 2u) << "what was not recorded does not count";
    EXPECT_NEAR(samples.p[0].x, 0.5f * 0.5f, 1e-6f);
    EXPECT_NEAR(samples.weight[0] / samples.weight[1], std::sin(kPi / 3) / std::sin(kPi / 6), 1e-5f);
    EXPECT_NEAR(samples.weight[0] + samples.weight[1], 1, 1e-6f);
    EXPECT_NEAR(samples.share, (std::sin(kPi / 3) + std::sin(kPi / 6)) * wi.z, 1e-5);
}

TEST(TransferSamples, FindTheIncidentDirectionOnBothSides) {
    GonioGrid grid{{10, 50}, {0}, 10, true};
    Material material;
    material.kd = Color3f(0.5f);
    material.lobes = {through(kurt_lobe(0.5f, 0.3f, 0.3f, 0.1f, 0.2f))};
    const std::vector<BrdfSample> pairs = measure(material, grid, {});
    for (const Side side : {Side::reflection, Side::transmission}) {
        const TransferSamples samples = transfer_samples(pairs, side);
        EXPECT_EQ(samples.incident_directions.size(), 2u);
        EXPECT_EQ(samples.wi_is_incident, side == Side::reflection);
        const std::vector<Color3f> model = model_transfer(material, samples, side);
        for (size_t j = 0; j < samples.size(); ++j) EXPECT_NEAR(samples.p[j].x, model[j].x, 1e-5f * (1 + model[j].x));
    }
}

TEST(TransferSamples, AlbedoIsTheMaterials) {
    GonioGrid grid = kGrid;
    grid.step_deg = 2;
    const Material material = one_lobe(0.2f);
    const std::vector<BrdfSample> pairs = measure(material, grid, {});
    const std::vector<IncidentAlbedo> albedo = measured_albedo(pairs, Side::reflection);
    ASSERT_EQ(albedo.size(), 7u);  // theta 0 is one direction
    for (const IncidentAlbedo& incident : albedo)
        EXPECT_NEAR(incident.albedo.x, 0.2f + directional_albedo(material.lobes[0], incident.incident).x, 0.01f);
}

TEST(TransferSamples, ThinnedOnesStandForAll) {
    const TransferSamples all = transfer_samples(measure(one_lobe(0.1f), kGrid, {}), Side::reflection);
    const TransferSamples few = thinned(all, 1500);
    EXPECT_LE(few.size(), 1600u);
    const auto light = [](const TransferSamples& samples) {
        double sum = 0;
        for (size_t j = 0; j < samples.size(); ++j) sum += samples.weight[j] * samples.p[j].x;
        return sum;
    };
    EXPECT_NEAR(light(few) / light(all), 1, 0.05);
    EXPECT_EQ(thinned(few, 5000).size(), few.size());
}

TEST(DiffuseMode, IsWhatMostOfTheTableShows) {
    Material material = one_lobe(0);
    material.kd = {0.4f, 0.1f, 0.02f};
    const Color3f kd = diffuse_mode(transfer_samples(measure(material, kGrid, {0.03f, 1e-4f, 15}), Side::reflection));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(kd[c] / material.kd[c], 1, 0.03f) << c;
}

TEST(DiffuseMode, IsNoneWithoutADiffusePart) {
    Material material = one_lobe(0);
    material.lobes[0].mx = material.lobes[0].my = 0.4f;
    EXPECT_EQ(diffuse_mode(transfer_samples(measure(material, kGrid, {0.03f}), Side::reflection)), Color3f(0));
}

TEST(TableNoise, IsFoundUnderAModelThatErrs) {
    Material truth = one_lobe(0.3f), wrong = one_lobe(0.28f, 0.9f);
    for (Material* material : {&truth, &wrong}) material->lobes[0].mx = material->lobes[0].my = 0.4f;  // wider than the grid
    const TransferSamples samples = transfer_samples(measure_grey(truth, kGrid, {0.05f}), Side::reflection);
    const double noise = l1_error(model_transfer(truth, samples, Side::reflection), samples).x;
    const std::vector<float> model = grey(model_transfer(wrong, samples, Side::reflection));
    EXPECT_NEAR(noise_level(samples, model) / noise, 1, 0.3);
}

TEST(RetroReflection, IsToldFromAMirrorPeak) {
    const std::vector<BrdfSample> ordinary = measure(one_lobe(0.1f), kGrid, {0.03f});
    EXPECT_FALSE(retro_reflection(transfer_samples(ordinary, Side::reflection)).seen());
    std::vector<BrdfSample> turned = ordinary;
    for (BrdfSample& sample : turned) sample.wo = {-sample.wo.x, -sample.wo.y, sample.wo.z};
    EXPECT_TRUE(retro_reflection(transfer_samples(turned, Side::reflection)).seen());
}

}  // namespace
}  // namespace burnish::testing
