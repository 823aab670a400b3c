// Adaptive sample counts: the predicted variance against brute force, what it saves, and that it leaves pixels alone.
#include "core/scenes.h"

#include <burnish/material/lobe.h>
#include <burnish/sampling/sample_ladder.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/dense.h>
#include <burnish/shading/table_shading.h>
#include <burnish/shading/tap_rule.h>

#include <gtest/gtest.h>

using namespace burnish;

namespace {

constexpr EstimatorKind kFiltered[] = {EstimatorKind::regular, EstimatorKind::filtered_importance, EstimatorKind::preconvolved};

EstimatorSettings estimator(EstimatorKind kind, int samples, bool adaptive) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples, settings.adaptive = adaptive;
    return settings;
}

Environment light_of(const Image& image) {
    EnvironmentSettings settings;
    settings.face_size = 256;
    return Environment::from_image(image, settings, "test light");
}

/// Bright above, dim below, with a soft edge and a few spots: smooth and busy pixels side by side.
Environment mixed_light() {
    Image image = scenes::stress_light(5, 256, 8);
    for (int y = 128; y < 256; ++y)
        for (int x = 0; x < 512; ++x) std::fill_n(image.at(x, y), 3, 0.5f);
    return light_of(image);
}

/// Waves some 40 degrees long and no spots, so that a few wide lookups can tell what the lobe holds.
Environment waved_light() {
    Image image(512, 256, 3);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            std::fill_n(image.at(x, y), 3, 1 + 0.9f * std::sin(8 * kPi * x / 256) * std::sin(8 * kPi * y / 256));
    return light_of(image);
}

SurfaceBatch sphere(int size) {
    const AovFrame frame = scenes::sphere_frame(size);
    const Assignment assignment = scenes::whole_frame(frame);
    SurfaceBatch batch;
    Surfaces(frame, assignment, {}).gather({0, 0, size, size}, 0, batch);
    return batch;
}

ShadedBatch shade(const LobeParameters& lobe, const Environment& light, const EstimatorSettings& settings,
                  const SurfaceBatch& batch) {
    ShadedBatch out;
    MaterialShader({"test", Color3f(0, 0, 0), {lobe}}, light, settings).shade(batch, out);
    return out;
}

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double squared_error(const ShadedBatch& test, const ShadedBatch& truth) {
    double sum = 0;
    for (size_t i = 0; i < test.overlay.size(); ++i) {
        const double d = luminance(test.overlay[i]) - luminance(truth.overlay[i]);
        sum += d * d;
    }
    return sum / static_cast<double>(test.overlay.size());
}

/// Relative variance of one importance sample of the lobe, by many.
double brute_variance(const LobeParameters& p, const Environment& light, const ShadingPoint& point) {
    return visit_lobe(p, [&](const auto& lobe) {
        constexpr uint32_t kCount = 4096;
        double sum = 0, square = 0;
        for (uint32_t i = 0; i < kCount; ++i) {
            const Vec3f wi = lobe.sample(point.wo, owen_sobol(i, 3));
            const float pdf = lobe.pdf(point.wo, wi);
            if (wi.z <= 0 || pdf <= 0) continue;
            const double x = luminance(lobe.eval(point.wo, wi) * light.radiance(point.frame.to_world(wi))) * wi.z / pdf;
            sum += x, square += x * x;
        }
        return square * kCount / (sum * sum) - 1;
    });
}

}  // namespace

TEST(Adaptive, KnowsTheVarianceUnderTheLobe) {
    const Environment light = waved_light();
    const SurfaceBatch batch = sphere(24);
    const LobeParameters lobe = scenes::lobe_of(ModelId::beckmann, 0.2f, 0.2f);
    const TapRule rule(lobe, estimator(EstimatorKind::regular, 4, false),
                       [&](float omega) { return light.pyramid().level(omega); });
    const TapTable table(lobe, rule.tap_count(lobe.mx, lobe.my), rule);
    std::vector<Color3f> overlay(batch.size(), Color3f(0));
    std::vector<float> samples(batch.size()), square(batch.size()), weight(batch.size());
    const LobeTable taps{lobe, table, light.world_to_light()};
    add_table_shading({taps, light.pyramid().stack(), CubePyramid::kDistortion, light.gain()}, batch,
                      {overlay, samples, square, weight});
    int steep = 0, near = 0;
    for (size_t i = 0; i < batch.size(); ++i) {
        const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
        if (point.wo.z < 0.3f) continue;
        const double truth = std::sqrt(brute_variance(lobe, light, point)),
                     deviation = std::sqrt(relative_variance(luminance(overlay[i]), square[i], weight[i]));
        ++steep, near += std::abs(deviation - truth) < 0.2 * truth + 0.05;
    }
    EXPECT_GT(steep, 200);
    EXPECT_GT(near, 0.9 * steep);
}

TEST(Adaptive, TakesTheFewestLookupsWhereLightIsConstant) {
    const Environment light = light_of(scenes::constant_light(2));
    for (const EstimatorKind kind : kFiltered)
        for (const float samples :
             shade(scenes::lobe_of(ModelId::ggx, 0.2f, 0.2f), light, estimator(kind, 30, true), sphere(16)).samples)
            EXPECT_LE(samples, kind == EstimatorKind::preconvolved ? 2 * kFewestLookups : kFewestLookups);  // predicts apart
}

TEST(Adaptive, SavesLookupsForNearlyTheSameImage) {
    const Environment light = mixed_light();
    const SurfaceBatch batch = sphere(32);
    EstimatorSettings exact = estimator(EstimatorKind::reference, 0, false);
    exact.tolerance = 0.003f;
    for (const ModelId model : {ModelId::kurt, ModelId::beckmann, ModelId::ggx}) {
        const LobeParameters lobe = scenes::lobe_of(model, 0.15f, 0.15f);
        const ShadedBatch truth = shade(lobe, light, exact, batch);
        for (const EstimatorKind kind : kFiltered) {
            if (model == ModelId::ggx && kind == EstimatorKind::preconvolved) continue;  // its tail sees spots from everywhere
            const ShadedBatch all = shade(lobe, light, estimator(kind, 61, false), batch),
                              chosen = shade(lobe, light, estimator(kind, 61, true), batch);
            const std::string name = std::string(model_info(model).name) + " " + std::to_string(static_cast<int>(kind));
            EXPECT_LT(mean(chosen.samples), 0.75 * mean(all.samples)) << name;
            EXPECT_LT(squared_error(chosen, truth), 1.5 * squared_error(all, truth)) << name;
            for (const float samples : chosen.samples) EXPECT_LE(samples, 61 + kFewestLookups + 1) << name;
        }
    }
}

TEST(Adaptive, PixelsDoNotDependOnTheirBatch) {
    const Environment light = mixed_light();
    const SurfaceBatch batch = sphere(20);
    const LobeParameters lobe = scenes::lobe_of(ModelId::ggx, 0.2f, 0.1f);
    for (EstimatorKind kind : {EstimatorKind::regular, EstimatorKind::preconvolved, EstimatorKind::reference}) {
        EstimatorSettings settings = estimator(kind, 30, true);
        settings.tolerance = 0.05f;
        const MaterialShader shader({"test", Color3f(0, 0, 0), {lobe, lobe}}, light, settings);
        ShadedBatch whole, alone;
        shader.shade(batch, whole);
        for (size_t i = 0; i < batch.size(); i += 7) {
            SurfaceBatch one;
            one.pixel = {batch.pixel[i]};
            for (const auto planes :
                 {&SurfaceBatch::p, &SurfaceBatch::n, &SurfaceBatch::ng, &SurfaceBatch::t, &SurfaceBatch::wo})
                if (!(batch.*planes).x.empty()) (one.*planes).push_back((batch.*planes)[i]);
            shader.shade(one, alone);
            EXPECT_EQ(whole.overlay[i], alone.overlay[0]);
            EXPECT_EQ(whole.samples[i], alone.samples[0]);
        }
    }
}

TEST(Adaptive, ReferenceStopsSoonerUnderSmoothLightAndKeepsItsTolerance) {
    const Environment light = waved_light();
    const SurfaceBatch batch = sphere(16);
    const LobeParameters lobe = scenes::lobe_of(ModelId::beckmann, 0.1f, 0.1f);
    EstimatorSettings settings = estimator(EstimatorKind::reference, 0, false), exact = settings;
    settings.tolerance = 0.01f, exact.tolerance = 0.001f;
    const ShadedBatch truth = shade(lobe, light, exact, batch), plain = shade(lobe, light, settings, batch);
    settings.adaptive = true;
    const ShadedBatch chosen = shade(lobe, light, settings, batch);
    EXPECT_LT(mean(chosen.samples), 0.8 * mean(plain.samples));
    int wrong = 0;
    for (size_t i = 0; i < batch.size(); ++i)
        wrong += std::abs(chosen.overlay[i].y - truth.overlay[i].y) > 3 * settings.tolerance * truth.overlay[i].y;
    EXPECT_LE(wrong, 0.03 * static_cast<double>(batch.size()));
}
