// Predictions under lights that are near: what moves past as the shaded point does, and sparse shading that follows from it.
#include "core/level_views.h"
#include "shading_cases.h"

#include <burnish/base/parallel.h>
#include <burnish/light/cube_map/cube_map_light.h>
#include <burnish/output/compare.h>
#include <burnish/shading/local_prediction.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/sparse.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

constexpr float kHalf = 3;  // of the room's edges

/// A cubic room of that size about the origin, with spots of light.
LightChain room() {
    OrientedBox box;
    box.half = Vec3f(kHalf);
    const CubeMapLight light(light_of(scenes::stress_light(3, 256)), {}, Vec3f(0), BoundingPlanes(box, Vec3f(0)));
    return LightChain({{std::make_shared<const Light>(light), true}});
}

LightChain sky() {
    const auto environment = std::make_shared<const Environment>(light_of(scenes::stress_light(3, 256)));
    return LightChain({{std::make_shared<const Light>(EnvironmentLight(environment)), true}});
}

DensitySettings sparse(float safety) { return {ShadingDensity::sparse, PredictionKind::curvature, 0, safety}; }

BandwidthPredictor predictor_of(const Material& material, const LightChain& lights, float safety = 1) {
    return BandwidthPredictor(std::make_shared<const MaterialProbes>(material, sparse(safety)), lights);
}

/// One point of a floor that faces up.
SurfaceBatch point(const Vec3f& p, const Vec3f& wo) {
    SurfaceBatch batch;
    batch.pixel.push_back(0), batch.p.push_back(p), batch.n.push_back({0, 0, 1}), batch.t.push_back({1, 0, 0});
    batch.wo.push_back(wo.normalized());
    return batch;
}

float shaded(const Material& material, const LightChain& lights, const SurfaceBatch& batch) {
    ShadedBatch out;
    MaterialShader(std::make_shared<const MaterialTaps>(material, EstimatorSettings{}), lights).shade(batch, out);
    return luminance(out.overlay[0]);
}

struct Shot {
    Shot(AovFrame own_frame, const LightChain& lights, float m, float safety)
        : frame(std::move(own_frame)), assignment(scenes::whole_frame(frame)), surfaces(frame, assignment, {}) {
        const Material worn = material(lobe(ModelId::ggx, m, m));
        shaders.emplace_back(std::make_shared<const MaterialTaps>(worn, EstimatorSettings{}), lights);
        predictors.push_back(predictor_of(worn, lights, safety));
    }
    ShadedFrame dense() const { return shade_dense(surfaces, assignment, shaders, {}); }
    ShadedFrame sparse() const { return shade_sparse(frame, surfaces, assignment, shaders, predictors, {}, true); }
    double shaded_share(const ShadedFrame& shown) const {
        const auto count = std::ranges::count_if(shown.samples.data, [](float n) { return n > 0; });
        return static_cast<double>(count) / static_cast<double>(surfaces.counts()[0]);
    }

    AovFrame frame;
    Assignment assignment;
    Surfaces surfaces;
    std::vector<MaterialShader> shaders;
    std::vector<BandwidthPredictor> predictors;
};

}  // namespace

/// A step of the point changes what is seen as much as a turn of the view by nearness times the way across the ray.
TEST(LocalPrediction, NearnessTurnsStepsIntoAngles) {
    const Material worn = material(lobe(ModelId::ggx, 0.03f, 0.03f));
    const LightChain lights = room();
    const BandwidthPredictor predictor = predictor_of(worn, lights);
    for (const Vec3f& r : {Vec3f(0.9f, 0.2f, 0.5f), Vec3f(0.1f, -0.9f, 0.3f), Vec3f(-0.2f, 0.3f, 0.9f)}) {
        const Vec3f d = r.normalized(), wo(-d.x, -d.y, d.z), p(0.4f, -0.3f, -1);
        AngularPrediction found;
        predictor.predict(point(p, wo), {&found, 1});
        const auto along = [&](int k) { return (std::copysign(kHalf, d[k]) - p[k]) / d[k]; };
        const float distance = std::min({along(0), along(1), along(2)});
        EXPECT_NEAR(found.nearness * distance, 1, 0.1f);
        for (const Vec3f& step : {Vec3f(0.02f, 0, 0), Vec3f(0, -0.02f, 0)}) {
            const Vec3f across = step - d * step.dot(d), turned = (d + across * found.nearness).normalized();
            const float here = shaded(worn, lights, point(p, wo)), moved = shaded(worn, lights, point(p + step, wo)),
                        seen = shaded(worn, lights, point(p, {-turned.x, -turned.y, turned.z}));
            EXPECT_NEAR(moved, seen, 0.25f * std::fabs(moved - here) + 0.002f * here);
        }
    }
}

/// Distant light through a chain is predicted as by its own predictor.
TEST(LocalPrediction, AgreesWithDistantLight) {
    const Environment light = light_of(scenes::stress_light(3, 256));
    for (const float m : {0.05f, 0.2f}) {
        const Material worn = material(lobe(ModelId::ggx, m, m));
        const SurfaceBatch batch = fan(0.7f);
        std::vector<AngularPrediction> own(batch.size()), distant(batch.size());
        predictor_of(worn, sky()).predict(batch, own);
        BandwidthPredictor(worn, light, sparse(1)).predict(batch, distant);
        for (size_t i = 0; i < batch.size(); ++i) {
            EXPECT_NEAR(own[i].nu_a, distant[i].nu_a, 0.02f * distant[i].nu_a);
            EXPECT_EQ(own[i].nearness, 0);
            EXPECT_EQ(own[i].reach, distant[i].reach);
        }
    }
}

TEST(LocalPrediction, FewPixelsOfAFloorComeNearToAll) {
    for (const float m : {0.05f, 0.2f})
        for (const auto& scene : {scenes::floor_only, scenes::table}) {
            const Shot shot(scenes::view_of(scene, 35, 0.5f, Vec3f(0, 0, -1), 480), room(), m, 1);
            const ShadedFrame sparse = shot.sparse();
            EXPECT_GT(compare_images(sparse.overlay, shot.dense().overlay, nullptr).display_psnr_db, 45) << m;
            EXPECT_LT(shot.shaded_share(sparse), 0.5) << m;
        }
}

TEST(LocalPrediction, BitsDoNotDependOnThreads) {
    const Shot shot(scenes::view_of(scenes::table, 35, 0.5f, Vec3f(0, 0, -1), 320), room(), 0.05f, 2);
    const ShadedFrame two = shot.sparse();
    const ThreadLimit one(1);
    const ShadedFrame single = shot.sparse();
    EXPECT_EQ(two.overlay.data, single.overlay.data);
    EXPECT_EQ(two.samples.data, single.samples.data);
}
