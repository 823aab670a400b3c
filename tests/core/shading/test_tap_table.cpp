// Tabulated taps against taps made for each pixel: the same picture, for every kind of lobe that a table covers.
#include "core/scenes.h"

#include <burnish/material/model.h>
#include <burnish/shading/material_shader.h>
#include <burnish/shading/tap_rule.h>
#include <burnish/shading/tap_table.h>
#include <burnish/surface/surfaces.h>

#include <gtest/gtest.h>

using namespace burnish;

namespace {

struct Case {
    const char* name;
    LobeParameters lobe;
    EstimatorSettings settings;
    double tolerance;  // relative RMS difference
};

LobeParameters lobe(ModelId model, float mx, float my, FresnelKind fresnel = FresnelKind::none) {
    LobeParameters p;
    p.model = model, p.mx = mx, p.my = my;
    p.fresnel.kind = fresnel, p.fresnel.eta = Color3f(0.04f, 0.5f, 0.9f);
    if (model == ModelId::kurt) p.extra = {0.4f};
    return p;
}

EstimatorSettings estimator(EstimatorKind kind, int samples) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples;
    return settings;
}

/// All pixels of a sphere whose geometric normals differ from the shading normals, with layers that vary.
SurfaceBatch bumpy_sphere(int size) {
    const AovFrame frame = scenes::sphere_frame(size);
    const Assignment assignment = scenes::whole_frame(frame);
    SurfaceBatch batch;
    Surfaces(frame, assignment, {}).gather({0, 0, size, size}, 0, batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        const Vec3f p = batch.p[i],
                    ng = (batch.n[i] + Vec3f(0.2f * std::sin(9 * p.x), 0.2f * std::cos(7 * p.y), 0)).normalized();
        const Vec3f own = ng.dot(batch.wo[i]) > 0 ? ng : batch.n[i];
        batch.ng.x[i] = own.x, batch.ng.y[i] = own.y, batch.ng.z[i] = own.z;
        batch.roughness.push_back(std::pow(0.05f + 0.6f * std::abs(std::sin(3 * p.y)), 2.0f));
        batch.rotation.push_back(p.x);
        batch.weight.push_back(0.5f + p.y * p.y);
        batch.tint.push_back({1, 0.5f, std::abs(p.x)});
    }
    return batch;
}

/// Each pixel by its own taps, one by one.
Color3f direct(const Case& c, const TapRule& rule, const Environment& light, const SurfaceBatch& batch, size_t i) {
    const ShadingPoint point = shading_point(batch, i, c.lobe, light.world_to_light());
    std::vector<Tap> taps(rule.tap_count(point.mx, point.my));
    rule(point, taps);
    Color3f sum(0, 0, 0);
    for (const Tap& tap : taps) {
        if (!point.sees(tap.wi, c.lobe.side == Side::transmission ? -1.0f : 1.0f)) continue;
        const Vec3f d = point.frame.to_world(tap.wi);
        sum += tap.weight * light.pyramid().lookup(d, tap.level + CubePyramid::kDistortion * cube_distortion(d));
    }
    return sum * point.scale * light.gain();
}

double relative_rms(const Case& c, const Environment& light, const SurfaceBatch& batch) {
    ShadedBatch tabulated;
    MaterialShader({"test", Color3f(0, 0, 0), {c.lobe}}, light, c.settings).shade(batch, tabulated);
    const TapRule rule(c.lobe, c.settings, [&](float omega) { return light.pyramid().level(omega) + c.settings.level_bias; });
    double difference = 0, total = 0;
    for (size_t i = 0; i < batch.size(); ++i) {
        const Color3f truth = direct(c, rule, light, batch, i);
        difference += (tabulated.overlay[i] - truth).length2(), total += truth.length2();
    }
    return std::sqrt(difference / total);
}

std::vector<Case> cases() {
    const EstimatorSettings regular = estimator(EstimatorKind::regular, 16),
                            importance = estimator(EstimatorKind::filtered_importance, 16);
    std::vector<Case> all;
    for (const ModelId model : {ModelId::kurt, ModelId::beckmann, ModelId::ggx})
        for (const EstimatorSettings& settings : {regular, importance}) {
            for (const float m : {0.01f, 0.1f, 0.4f}) all.push_back({"isotropic", lobe(model, m, m), settings, 2e-3});
            all.push_back({"anisotropic", lobe(model, 0.3f, 0.06f), settings, 2e-3});
            all.push_back({"line", lobe(model, 0.02f, 0.3f), settings, 2e-3});
            all.push_back({"fresnel", lobe(model, 0.2f, 0.2f, FresnelKind::schlick), settings, 2e-3});
            all.push_back({"rough layer", lobe(model, 0.1f, 0.1f), settings, 2e-3});
            all.back().lobe.per_pixel.roughness = true;
            all.push_back({"rough, turned layers", lobe(model, 0.2f, 0.1f), settings, 4e-3});
            all.back().lobe.per_pixel = {true, false, true, true, true};
            all.push_back({"turned", lobe(model, 0.3f, 0.1f), settings, 2e-3});
            all.back().lobe.rotation = 0.7f;
            all.push_back({"transmission", lobe(model, 0.2f, 0.2f), settings, 2e-3});
            all.back().lobe.side = Side::transmission;
            all.push_back({"turned transmission", lobe(model, 0.3f, 0.1f), settings, 5e-3});
            all.back().lobe.rotation = 0.7f, all.back().lobe.side = Side::transmission;
        }
    return all;
}

}  // namespace

TEST(TapTable, MakesThePictureOfTheTapsThemselves) {
    EnvironmentSettings settings;
    settings.face_size = 256;
    const Environment light = Environment::from_image(scenes::stress_light(5, 256), settings, "stress");
    const SurfaceBatch batch = bumpy_sphere(96);
    for (const Case& c : cases()) {
        const double rms = relative_rms(c, light, batch);
        EXPECT_LT(rms, c.tolerance) << c.name << " " << model_info(c.lobe.model).name << " m " << c.lobe.mx << " " << c.lobe.my
                                    << " estimator " << static_cast<int>(c.settings.kind);
    }
}
