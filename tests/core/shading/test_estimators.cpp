// The estimators against what they must equal: albedo in the white furnace, brute-force quadrature, each other.
#include "shading_cases.h"

#include <gtest/gtest.h>

using namespace burnish_test;

TEST(WhiteFurnace, ReferenceIsTheDirectionalAlbedo) {
    const Environment light = light_of(scenes::constant_light(1));
    for (const LobeParameters& p :
         {lobe(ModelId::beckmann, 0.1f, 0.1f), lobe(ModelId::ggx, 0.3f, 0.3f), lobe(ModelId::ggx, 0.05f, 0.4f),
          lobe(ModelId::kurt, 0.2f, 0.2f), lobe(ModelId::beckmann, 0.02f, 0.02f)}) {
        const SurfaceBatch batch = fan(0.3f);
        const ShadedBatch out = shade(material(p), light, estimator(EstimatorKind::reference), batch);
        for (size_t i = 0; i < batch.size(); ++i)
            EXPECT_NEAR(out.overlay[i].y, directional_albedo(p, batch.wo[i], 1 << 16).y, 1e-3)
                << model_info(p.model).name << " " << i;
    }
}

TEST(WhiteFurnace, RegularKeepsTheAlbedoUpToSixtyDegrees) {
    // With the albedo table and without, in the source's own setting: no shadowing (Kurt with alpha 0).
    const Environment light = light_of(scenes::constant_light(1));
    EstimatorSettings plain = estimator(EstimatorKind::regular);
    plain.albedo_correction = false;
    for (const EstimatorSettings& settings : {estimator(EstimatorKind::regular), plain})
        for (const float m : {0.02f, 0.05f, 0.1f, 0.2f}) {
            LobeParameters p = lobe(ModelId::kurt, m, m);
            p.extra = {0.0f};
            const SurfaceBatch batch = fan(0.0f, 23);  // steps of 4 degrees
            const ShadedBatch out = shade(material(p), light, settings, batch);
            for (size_t i = 0; i <= 15; ++i)
                EXPECT_NEAR(out.overlay[i].y / directional_albedo(p, batch.wo[i], 1 << 14).y, 1, 0.01)
                    << "m " << m << " at " << 4 * i;
        }
}

TEST(WhiteFurnace, AlbedoCorrectionHoldsAtGrazingAngles) {
    const Environment light = light_of(scenes::constant_light(1));
    for (const EstimatorKind kind : {EstimatorKind::regular, EstimatorKind::filtered_importance, EstimatorKind::preconvolved})
        for (const LobeParameters& p :
             {lobe(ModelId::beckmann, 0.2f, 0.2f), lobe(ModelId::ggx, 0.3f, 0.3f), lobe(ModelId::kurt, 0.2f, 0.05f)})
            for (const float phi : {0.0f, 0.7f, 1.5f}) {
                const SurfaceBatch batch = fan(phi);
                const ShadedBatch out = shade(material(p), light, estimator(kind), batch);
                for (size_t i = 0; i < batch.size(); ++i)
                    EXPECT_NEAR(out.overlay[i].y / directional_albedo(p, batch.wo[i], 1 << 14).y, 1, 0.03)
                        << model_info(p.model).name << " phi " << phi << " step " << i;
            }
}

TEST(Reference, MatchesBruteForceAndKnowsItsError) {
    const Environment light = light_of(scenes::stress_light(7, 256));
    EstimatorSettings settings = estimator(EstimatorKind::reference);
    settings.tolerance = 2e-3f;
    for (const LobeParameters& p :
         {lobe(ModelId::ggx, 0.3f, 0.3f), lobe(ModelId::beckmann, 0.2f, 0.5f), lobe(ModelId::kurt, 0.3f, 0.3f)}) {
        const SurfaceBatch batch = fan(0.9f, 6);
        const ShadedBatch out = shade(material(p), light, settings, batch);
        for (size_t i = 0; i < batch.size(); ++i) {
            const float truth = brute_force(p, light, batch.wo[i]).y;
            EXPECT_NEAR(out.overlay[i].y, truth, 5 * out.standard_error[i] + 2e-3f * truth) << i;
            EXPECT_LT(out.standard_error[i], 4e-3f * truth);
        }
    }
}

TEST(Reference, StopsAtItsCap) {
    const Environment light = light_of(scenes::stress_light(3, 128));
    EstimatorSettings settings = estimator(EstimatorKind::reference);
    settings.tolerance = 1e-9f, settings.max_samples = 1024;
    const ShadedBatch out = shade(material(lobe(ModelId::ggx, 0.3f, 0.3f)), light, settings, fan(0, 4));
    for (const float samples : out.samples) EXPECT_EQ(samples, 1024);
}

TEST(Regular, ApproachesTheReferenceAsSamplesGrow) {
    const Environment light = light_of(scenes::stress_light(5, 256));
    const Material m = material(lobe(ModelId::beckmann, 0.2f, 0.2f));
    const SurfaceBatch batch = fan(0.4f, 8);
    EstimatorSettings exact = estimator(EstimatorKind::reference);
    exact.tolerance = 1e-3f;
    const ShadedBatch truth = shade(m, light, exact, batch);
    for (const EstimatorKind kind : {EstimatorKind::regular, EstimatorKind::filtered_importance}) {
        const auto error = [&](int samples, float border) {
            EstimatorSettings few = estimator(kind, samples);
            few.border = border, few.level_bias = -1;
            const ShadedBatch out = shade(m, light, few, batch);
            double sum = 0;
            for (size_t i = 0; i < batch.size(); ++i)
                sum += std::abs(out.overlay[i].y - truth.overlay[i].y) / truth.overlay[i].y;
            return sum / batch.size();
        };
        EXPECT_LT(error(2000, 1e-4f), 0.02);
        EXPECT_LT(error(2000, 1e-4f), 0.5 * error(61, 0));
        EXPECT_LT(error(61, 0), error(7, 0));
    }
}

TEST(Regular, AllQuadraturesAgreeOnASmoothLight) {
    Image slope(64, 32, 3);
    for (size_t i = 0; i < slope.pixel_count(); ++i) std::fill_n(slope.at(i), 3, 1 + 0.5f * std::sin(i / 64 * kPi / 32));
    const Environment light = light_of(slope);
    const Material m = material(lobe(ModelId::ggx, 0.1f, 0.1f));
    const SurfaceBatch batch = fan(0, 6);
    const ShadedBatch plain = shade(m, light, estimator(EstimatorKind::regular), batch);
    for (const Quadrature quadrature : {Quadrature::energy, Quadrature::energy_squared}) {
        EstimatorSettings settings = estimator(EstimatorKind::regular);
        settings.quadrature = quadrature;
        const ShadedBatch out = shade(m, light, settings, batch);
        for (size_t i = 0; i < batch.size(); ++i) EXPECT_NEAR(out.overlay[i].y / plain.overlay[i].y, 1, 0.03) << i;
    }
}

TEST(Shading, TransmissionReadsTheLightBehind) {
    Image half_lit(64, 32, 3);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) std::fill_n(half_lit.at(x, y), 3, y < 16 ? 0.0f : 1.0f);  // bright below the horizon
    const Environment light = light_of(half_lit);
    LobeParameters p = lobe(ModelId::beckmann, 0.05f, 0.05f);
    SurfaceBatch batch;
    batch.pixel = {0};
    batch.p.push_back({0, 0, 0}), batch.n.push_back({0, 1, 0}), batch.ng.push_back({0, 1, 0}), batch.t.push_back({1, 0, 0});
    batch.wo.push_back(Vec3f(0.3f, 1, 0).normalized());
    for (const EstimatorKind kind :
         {EstimatorKind::regular, EstimatorKind::filtered_importance, EstimatorKind::preconvolved, EstimatorKind::reference}) {
        p.side = Side::reflection;
        EXPECT_NEAR(shade(material(p), light, estimator(kind), batch).overlay[0].y, 0, 0.02);
        p.side = Side::transmission;
        EXPECT_NEAR(shade(material(p), light, estimator(kind), batch).overlay[0].y, 1, 0.02);
    }
}

TEST(Shading, GeometricNormalCutsTheLobe) {
    const Environment light = light_of(scenes::constant_light(1));
    const LobeParameters p = lobe(ModelId::ggx, 0.3f, 0.3f);
    SurfaceBatch batch = fan(0, 12);
    batch.ng.clear();
    const Vec3f ng = Vec3f(0.5f, 0, 1).normalized();
    for (size_t i = 0; i < batch.size(); ++i) batch.ng.push_back(ng);
    const ShadedBatch reference = shade(material(p), light, estimator(EstimatorKind::reference), batch);
    const ShadedBatch regular = shade(material(p), light, estimator(EstimatorKind::regular, 91), batch);
    for (const size_t i : {0, 6, 9}) {
        const Color3f truth = brute_force(p, light, batch.wo[i], ng), uncut = brute_force(p, light, batch.wo[i]);
        EXPECT_NEAR(reference.overlay[i].y, truth.y, 3e-3) << i;
        EXPECT_NEAR(regular.overlay[i].y, truth.y, 0.05) << i;
        if (i == 9) {
            EXPECT_LT(truth.y, 0.8f * uncut.y);
        }
    }
}

TEST(Shading, ConstantLayersEqualTheLobesOwnNumbers) {
    const Environment light = light_of(scenes::stress_light(11, 128));
    LobeParameters p = lobe(ModelId::ggx, 0.2f, 0.2f);
    SurfaceBatch batch = fan(0.2f, 6);
    const ShadedBatch own = shade(material(p), light, estimator(EstimatorKind::regular), batch);
    p.mx = p.my = 0.05f;
    p.per_pixel.roughness = p.per_pixel.weight = p.per_pixel.tint = true;
    batch.roughness.assign(batch.size(), 0.2f);
    batch.weight.assign(batch.size(), 0.5f);
    for (size_t i = 0; i < batch.size(); ++i) batch.tint.push_back({1, 0, 2});
    const ShadedBatch layered = shade(material(p), light, estimator(EstimatorKind::regular), batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        EXPECT_NEAR(layered.overlay[i].x / own.overlay[i].x, 0.5, 0.005);
        EXPECT_EQ(layered.overlay[i].y, 0);
        EXPECT_NEAR(layered.overlay[i].z / own.overlay[i].z, 1, 0.01);
    }
}

TEST(Shading, TurningTheLobeEqualsTurningTheTangent) {
    const Environment light = light_of(scenes::stress_light(13, 128));
    LobeParameters p = lobe(ModelId::ggx, 0.4f, 0.05f);
    SurfaceBatch batch = fan(0.2f, 6);
    p.rotation = 0.7f;
    const ShadedBatch turned = shade(material(p), light, estimator(EstimatorKind::regular), batch);
    p.rotation = 0;
    batch.t.clear();
    for (size_t i = 0; i < batch.size(); ++i) batch.t.push_back({std::cos(0.7f), std::sin(0.7f), 0});
    const ShadedBatch tangent = shade(material(p), light, estimator(EstimatorKind::regular), batch);
    for (size_t i = 0; i < batch.size(); ++i)
        EXPECT_NEAR(turned.overlay[i].y, tangent.overlay[i].y, 1e-4f * tangent.overlay[i].y);
}

TEST(Shading, GivesTheSameBitsForAnyThreadCount) {
    const AovFrame frame = scenes::sphere_frame(100);
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const Environment light = light_of(scenes::stress_light(17, 128));
    const auto render = [&](int threads, EstimatorKind kind) {
        const ThreadLimit limit(threads);
        EstimatorSettings settings = estimator(kind);
        settings.max_samples = 512;
        return shade_dense(surfaces, assignment, {MaterialShader(material(lobe(ModelId::ggx, 0.1f, 0.1f)), light, settings)},
                           {});
    };
    for (const EstimatorKind kind :
         {EstimatorKind::regular, EstimatorKind::filtered_importance, EstimatorKind::preconvolved, EstimatorKind::reference})
        EXPECT_EQ(render(1, kind).overlay.data, render(2, kind).overlay.data);
}

TEST(Shading, CancellationLeavesByException) {
    const AovFrame frame = scenes::sphere_frame(64);
    const Assignment assignment = scenes::whole_frame(frame);
    const Environment light = light_of(scenes::constant_light(1));
    const Progress stop([](const std::string&, float done) { return done < 0.5f; });
    const MaterialShader shader(material(lobe(ModelId::ggx, 0.1f, 0.1f)), light, estimator(EstimatorKind::regular));
    EXPECT_THROW(shade_dense(Surfaces(frame, assignment, {}), assignment, {shader}, stop), Error);
}
