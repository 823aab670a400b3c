// The preconvolved estimator: near the reference, and no blurrier than the lobe.
#include "shading_cases.h"

#include <gtest/gtest.h>

using namespace burnish_test;

TEST(Preconvolved, ApproachesTheReferenceAsSamplesGrow) {
    // Up to the part of the light that the filter takes and the lobe would have let through.
    const Environment light = light_of(scenes::stress_light(5, 256));
    const SurfaceBatch batch = fan(0.4f, 8);
    EstimatorSettings exact = estimator(EstimatorKind::reference);
    exact.tolerance = 1e-3f;
    for (const auto& [p, bias] : {std::pair{lobe(ModelId::beckmann, 0.1f, 0.1f), 0.03},
                                  {lobe(ModelId::kurt, 0.1f, 0.1f), 0.03},
                                  {lobe(ModelId::ggx, 0.1f, 0.1f), 0.1},
                                  {lobe(ModelId::beckmann, 0.2f, 0.075f), 0.05}}) {
        const ShadedBatch truth = shade(material(p), light, exact, batch);
        const auto error = [&, &p = p](int samples) {
            const ShadedBatch out = shade(material(p), light, estimator(EstimatorKind::preconvolved, samples), batch);
            double sum = 0;
            for (size_t i = 0; i < batch.size(); ++i)
                sum += std::abs(out.overlay[i].y - truth.overlay[i].y) / truth.overlay[i].y;
            return sum / batch.size();
        };
        EXPECT_LT(error(1000), bias) << model_info(p.model).name;
        EXPECT_LT(error(1000), 0.5 * error(32)) << model_info(p.model).name;
        EXPECT_LT(error(32), 0.6 * error(4)) << model_info(p.model).name;
    }
}

TEST(Preconvolved, BlursNoMoreThanTheLobe) {
    // A small lamp through a smooth lobe: as sharp a highlight as the reference's, where filter and lobe one after the other would
    // be wider by sqrt(1 + 0.6^2) and lower by the square of it.
    Image lamp(512, 256, 3);
    for (int y = 125; y < 131; ++y)
        for (int x = 253; x < 259; ++x) std::fill_n(lamp.at(x, y), 3, 100.0f);
    EnvironmentSettings kept;
    kept.face_size = 256, kept.suns = Suns::keep, kept.convention = EnvironmentConvention::openexr;
    const Environment light = Environment::from_image(lamp, kept, "lamp");
    SurfaceBatch batch;
    batch.pixel = {0};
    const Vec3f up = Vec3f(0, 0, 1) * light.world_to_light().transposed();
    for (Vec3Planes* planes : {&batch.n, &batch.ng, &batch.wo}) planes->push_back(up);
    batch.p.push_back({0, 0, 0}), batch.t.push_back(Vec3f(0, 1, 0) - up * up.y);
    const Material m = material(lobe(ModelId::beckmann, 0.1f, 0.1f));
    const float peak = shade(m, light, estimator(EstimatorKind::reference), batch).overlay[0].y;
    EXPECT_GT(peak, 1);
    EXPECT_NEAR(shade(m, light, estimator(EstimatorKind::preconvolved, 500), batch).overlay[0].y / peak, 1, 0.05);
}
