// Tabulated taps against taps made for each pixel: the same picture, for every kind of lobe that a table covers.
#include "core/scenes.h"
#include "core/simd_targets.h"

#include <burnish/material/model.h>
#include <burnish/shading/fitted.h>
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
    SurfaceSettings surfaces;
    surfaces.tangent_axis = Vec3f(0.3f, 1, 0);  // so that views come from all azimuths
    Surfaces(frame, assignment, surfaces).gather({0, 0, size, size}, 0, batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        const Vec3f p = batch.p[i],
                    ng = (batch.n[i] + Vec3f(0.2f * std::sin(9 * p.x), 0.2f * std::cos(7 * p.y), 0)).normalized();
        const Vec3f own = ng.dot(batch.wo[i]) > 0 ? ng : batch.n[i];
        batch.ng.push_back(own);
        batch.roughness.push_back(std::pow(0.05f + 0.6f * std::abs(std::sin(3 * p.y)), 2.0f));
        batch.rotation.push_back(p.x);
        batch.weight.push_back(0.5f + p.y * p.y);
        batch.tint.push_back({1, 0.5f, std::abs(p.x)});
    }
    return batch;
}

Environment stress() {
    EnvironmentSettings settings;
    settings.face_size = 256;
    return Environment::from_image(scenes::stress_light(5, 256), settings, "stress");
}

/// Each pixel by its own taps, one by one.
Color3f direct(const Case& c, const TapRule& rule, const Environment& light, const SurfaceBatch& batch, size_t i) {
    const ShadingPoint point = shading_point(batch, i, c.lobe, light.world_to_light());
    std::vector<Tap> taps(rule.tap_count(point.mx, point.my));
    rule(point, taps);
    const bool gaussian = c.settings.kind == EstimatorKind::preconvolved;
    Color3f sum(0, 0, 0);
    for (const Tap& tap : taps) {
        if (!point.sees(tap.wi, c.lobe.side == Side::transmission ? -1.0f : 1.0f)) continue;
        const Vec3f d = point.frame.to_world(tap.wi);
        sum += tap.weight * (gaussian ? light.gaussian_stack().stack().lookup(d, tap.level)
                                      : light.pyramid().lookup(d, tap.level + CubePyramid::kDistortion * cube_distortion(d)));
    }
    return sum * point.scale * light.gain();
}

/// Each pixel by its fitted taps, one by one; those that reach below the geometric surface fade.
Color3f direct_fitted(const LobeParameters& lobe, const TapTable& table, const Environment& light, const SurfaceBatch& batch,
                      size_t i) {
    const GaussianStack& stack = light.gaussian_stack();
    const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
    std::vector<Tap> taps(table.tap_count());
    table.at(point, taps);
    Color3f sum(0, 0, 0);
    for (const Tap& tap : taps) {
        const float part = visible_share(tap.wi.z, point.ng.dot(tap.wi), tap.edge);
        sum += tap.weight * part * stack.stack().lookup(point.frame.to_world(tap.wi), tap.level);
    }
    return sum * point.scale * light.gain();
}

/// One pixel seen at 45 degrees; its geometric normal is tilted away from the mirror direction.
SurfaceBatch tilted_pixel(float tilt) {
    SurfaceBatch batch;
    batch.pixel = {0};
    batch.p.push_back({0, 0, 0}), batch.n.push_back({0, 0, 1}), batch.t.push_back({1, 0, 0});
    batch.wo.push_back(Vec3f(1, 0, 1).normalized()), batch.ng.push_back({std::sin(tilt), 0, std::cos(tilt)});
    return batch;
}

MaterialShader shader_of(const Case& c, const Environment& light) {
    return {{"test", Color3f(0, 0, 0), {c.lobe}}, light, c.settings};
}

ShadedBatch shade(const MaterialShader& shader, const SurfaceBatch& batch) {
    ShadedBatch out;
    shader.shade(batch, out);
    return out;
}

double relative_rms(const Case& c, const Environment& light, const SurfaceBatch& batch) {
    const ShadedBatch tabulated = shade(shader_of(c, light), batch);
    const TapRule rule(c.lobe, c.settings, [&](float size) {
        const bool gaussian = c.settings.kind == EstimatorKind::preconvolved;
        return gaussian ? light.gaussian_stack().level(size) : light.pyramid().level(size) + c.settings.level_bias;
    });
    double difference = 0, total = 0;
    for (size_t i = 0; i < batch.size(); ++i) {
        const Color3f truth = direct(c, rule, light, batch, i);
        difference += (tabulated.overlay[i] - truth).length2(), total += truth.length2();
    }
    return std::sqrt(difference / total);
}

std::vector<Case> cases() {
    const EstimatorSettings regular = estimator(EstimatorKind::regular, 16),
                            importance = estimator(EstimatorKind::filtered_importance, 13),
                            preconvolved = estimator(EstimatorKind::preconvolved, 13);
    std::vector<Case> all;
    for (const ModelId model : {ModelId::kurt, ModelId::beckmann, ModelId::ggx})
        for (const EstimatorSettings& settings : {regular, importance, preconvolved}) {
            for (const float m : {0.01f, 0.1f, 0.4f}) all.push_back({"isotropic", lobe(model, m, m), settings, 2e-3});
            all.push_back({"anisotropic", lobe(model, 0.3f, 0.06f), settings, 2e-3});
            all.push_back({"line", lobe(model, 0.02f, 0.3f), settings, 2e-3});
            all.push_back({"fresnel", lobe(model, 0.2f, 0.2f, FresnelKind::schlick), settings, 2e-3});
            all.push_back({"rough layer", lobe(model, 0.1f, 0.1f), settings, 2e-3});
            all.back().lobe.per_pixel.roughness = true;
            all.push_back({"rough, turned layers", lobe(model, 0.2f, 0.1f), settings, 3e-3});
            all.back().lobe.per_pixel = {true, false, true, true, true};
            all.push_back({"turned", lobe(model, 0.3f, 0.1f), settings, 2e-3});
            all.back().lobe.rotation = 0.7f;
            all.push_back({"transmission", lobe(model, 0.2f, 0.2f), settings, 2e-3});
            all.back().lobe.side = Side::transmission;
            all.push_back({"turned transmission", lobe(model, 0.3f, 0.1f), settings, 2e-3});
            all.back().lobe.rotation = 0.7f, all.back().lobe.side = Side::transmission;
        }
    // Samples of a long lobe turn with the view, and preconvolved ones are read with a filter as narrow as its short side.
    for (Case& c : all) {
        const float aspect = std::max(c.lobe.mx / c.lobe.my, c.lobe.my / c.lobe.mx);
        if (c.settings.kind == EstimatorKind::preconvolved && aspect > 1) c.tolerance = aspect > 10 ? 2e-2 : 9e-3;
    }
    all.push_back(
        {"more taps than fit at once", lobe(ModelId::kurt, 0.2f, 0.2f), estimator(EstimatorKind::regular, 300), 2e-3});
    return all;
}

/// Pixels [first, first + count) of a batch.
SurfaceBatch part_of(const SurfaceBatch& batch, size_t first, size_t count) {
    SurfaceBatch part;
    const auto copy = [&](const std::vector<float>& from, std::vector<float>& to) {
        to.assign(from.begin() + first, from.begin() + first + count);
    };
    part.pixel.assign(batch.pixel.begin() + first, batch.pixel.begin() + first + count);
    for (const auto planes :
         {&SurfaceBatch::p, &SurfaceBatch::n, &SurfaceBatch::ng, &SurfaceBatch::t, &SurfaceBatch::wo, &SurfaceBatch::tint})
        for (size_t i = first; i < first + count; ++i) (part.*planes).push_back((batch.*planes)[i]);
    copy(batch.roughness, part.roughness), copy(batch.rotation, part.rotation), copy(batch.weight, part.weight);
    return part;
}

}  // namespace

TEST(TapTable, MakesThePictureOfTheTapsThemselves) {
    const Environment light = stress();
    const SurfaceBatch batch = bumpy_sphere(64);
    for (const Case& c : cases()) {
        const double rms = relative_rms(c, light, batch);
        EXPECT_LT(rms, c.tolerance) << c.name << " " << model_info(c.lobe.model).name << " m " << c.lobe.mx << " " << c.lobe.my
                                    << " estimator " << static_cast<int>(c.settings.kind);
    }
}

TEST(TapTable, GivesBackWhatWasSetAtItsNodes) {
    LobeParameters p = lobe(ModelId::ggx, 0.2f, 0.1f);
    p.side = Side::transmission;
    TapTable table(p, 3);
    const int round = table.axes()[1].stride * (table.axes()[1].count - 1);  // the last azimuth is the first again
    const auto taps_of = [&](int node) {
        const float x = static_cast<float>(node % round % 100) / 100;
        return std::array<Tap, 3>{Tap{Vec3f(x, 0.3f, -1).normalized(), x, {x, 1, 0}},
                                  Tap{Vec3f(-0.2f, x, -1).normalized(), -x, {0, 0, x}}, Tap{}};
    };
    for (int node = 0; node < table.node_count(); ++node) table.set(node, taps_of(node));
    for (int node = 0; node < table.node_count(); node += 37) {
        std::array<Tap, 3> found;
        table.at(table.node_point(node), found);
        const auto given = taps_of(node);
        for (int i = 0; i < 2; ++i) {
            EXPECT_LT((found[i].wi.normalized() - given[i].wi).length(), 2e-3f) << node;
            EXPECT_NEAR(found[i].level, given[i].level, 1e-3f) << node;
            EXPECT_LT((found[i].weight - given[i].weight).length(), 1e-3f) << node;
        }
    }
}

TEST(TapTable, MakesThePictureOfFittedTapsThemselves) {
    const Environment light = stress();
    const SurfaceBatch batch = bumpy_sphere(64);
    Case c{"fitted", lobe(ModelId::ggx, 0.3f, 0.3f, FresnelKind::schlick), estimator(EstimatorKind::fitted, 5), 0};
    const TapTable table = fitted_table(c.lobe, 5, light.gaussian_stack());
    const ShadedBatch tabulated = shade(shader_of(c, light), batch);
    double difference = 0, total = 0;
    for (size_t i = 0; i < batch.size(); ++i) {
        const Color3f truth = direct_fitted(c.lobe, table, light, batch, i);
        difference += (tabulated.overlay[i] - truth).length2(), total += truth.length2();
    }
    EXPECT_LT(std::sqrt(difference / total), 1e-3);
}

TEST(TapTable, FittedTapsFadeBelowTheGeometricSurface) {
    const Environment light = Environment::from_image(scenes::constant_light(1), {}, "constant");
    const Case c{"fitted", lobe(ModelId::ggx, 0.3f, 0.3f), estimator(EstimatorKind::fitted, 4), 0};
    const MaterialShader shader = shader_of(c, light);
    const auto seen = [&](float degrees) { return shade(shader, tilted_pixel(degrees * kPi / 180)).overlay[0].x; };
    const float whole = seen(0);
    float last = whole;
    for (float degrees = 0.5f; degrees <= 90; degrees += 0.5f) {
        const float now = seen(degrees);
        EXPECT_LE(now, last + 1e-5f * whole) << degrees;
        EXPECT_GT(now, last - 0.03f * whole) << degrees;
        last = now;
    }
    EXPECT_LT(last, 0.5f * whole);
}

TEST(TapTable, TapsWithoutWeightAreNotLookedUp) {
    const Environment light = stress();
    const Case c{"regular", lobe(ModelId::ggx, 0.1f, 0.1f), estimator(EstimatorKind::regular, 16), 0};
    const MaterialShader shader = shader_of(c, light);
    const TapRule rule(c.lobe, c.settings, [](float) { return 0.0f; });
    const auto taps = static_cast<float>(rule.tap_count(0.1f, 0.1f));
    EXPECT_EQ(shade(shader, tilted_pixel(0)).samples[0], taps);
    const float half_hidden = shade(shader, tilted_pixel(kPi / 4)).samples[0];
    EXPECT_GT(half_hidden, 0);
    EXPECT_LT(half_hidden, taps);
    EXPECT_EQ(shade(shader, tilted_pixel(kPi / 2)).samples[0], 0);
}

TEST(TapTable, EveryInstructionSetMakesTheSamePicture) {
    const Environment light = stress();
    const SurfaceBatch batch = bumpy_sphere(40);
    std::vector<Case> all = cases();
    all.push_back({"fitted", lobe(ModelId::ggx, 0.2f, 0.2f), estimator(EstimatorKind::fitted, 5), 0});
    for (const Case& c : all) {
        if (c.lobe.model != ModelId::ggx) continue;
        const MaterialShader shader = shader_of(c, light);
        const ShadedBatch usual = shade(shader, batch);
        double total = 0;
        for (const Color3f& overlay : usual.overlay) total += overlay.length2();
        burnish_test::for_each_target([&] {
            const ShadedBatch here = shade(shader, batch);
            double difference = 0;
            for (size_t i = 0; i < batch.size(); ++i) difference += (here.overlay[i] - usual.overlay[i]).length2();
            EXPECT_LT(std::sqrt(difference / total), 1e-4) << c.name;
        });
    }
}

TEST(TapTable, APixelIsTheSameBitsInWhateverBatchItComes) {
    const Environment light = stress();
    const SurfaceBatch batch = bumpy_sphere(24);
    Case c{"all layers", lobe(ModelId::beckmann, 0.2f, 0.1f), estimator(EstimatorKind::regular, 7), 0};
    c.lobe.per_pixel = {true, false, true, true, true};
    const MaterialShader shader = shader_of(c, light);
    const ShadedBatch whole = shade(shader, batch);
    for (const size_t size : {1, 3, 8, 37})
        for (size_t first = 0; first + size <= batch.size(); first += size + 2) {
            const ShadedBatch part = shade(shader, part_of(batch, first, size));
            for (size_t i = 0; i < size; ++i) ASSERT_EQ(part.overlay[i], whole.overlay[first + i]) << size << " from " << first;
        }
}
