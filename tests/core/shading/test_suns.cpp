// Few-sample shading under skies with a sun: taken out of the map against kept in it, both against `reference`.
#include "core/data.h"
#include "core/light/sun_pictures.h"
#include "core/scenes.h"

#include <burnish/material/model.h>
#include <burnish/output/compare.h>
#include <burnish/shading/dense.h>

#include <gtest/gtest.h>

#include <cstdio>

using namespace burnish;

namespace {

/// A sphere of one lobe under one light, by any estimator.
class Ball {
public:
    explicit Ball(int size) : m_frame(scenes::sphere_frame(size)), m_assignment(scenes::whole_frame(m_frame)) {}

    ShadedFrame shade(const LobeParameters& lobe, const Environment& light, EstimatorKind kind) const {
        EstimatorSettings settings;
        settings.kind = kind, settings.tolerance = 0.004f;
        const Surfaces surfaces(m_frame, m_assignment, {});
        return shade_dense(surfaces, m_assignment, {MaterialShader({"ball", Color3f(0, 0, 0), {lobe}}, light, settings)}, {},
                           true);
    }

private:
    AovFrame m_frame;
    Assignment m_assignment;
};

LobeParameters round_lobe(ModelId model, float m) { return scenes::lobe_of(model, m, m); }

struct KeptAndTaken {
    Comparison kept, taken;
};

/// Error of the default `regular` with the suns in the map, and with the suns apart.
KeptAndTaken errors(const Ball& ball, const LobeParameters& lobe, const Environment& kept, const Environment& taken) {
    const ShadedFrame truth = ball.shade(lobe, kept, EstimatorKind::reference);
    const auto error = [&](const Environment& light) {
        return compare_images(ball.shade(lobe, light, EstimatorKind::regular).overlay, truth.overlay, &truth.samples);
    };
    return {error(kept), error(taken)};
}

EnvironmentSettings keeping(EnvironmentSettings settings = {}) {
    settings.suns = Suns::keep;
    return settings;
}

}  // namespace

TEST(Suns, ApartMakeFewSamplesSeveralTimesMoreExact) {
    const Image sky = burnish_test::sunny_latlong({{{0.5f, 0.6f, 0.4f}}}, 512);
    const Environment kept = Environment::from_image(sky, keeping(), "kept"), taken = Environment::from_image(sky, {}, "taken");
    ASSERT_EQ(taken.discs().size(), 1u);
    const Ball ball(32);
    for (const ModelId model : {ModelId::kurt, ModelId::beckmann, ModelId::ggx})
        for (const float m : {0.05f, 0.1f, 0.3f}) {
            const KeptAndTaken e = errors(ball, round_lobe(model, m), kept, taken);
            EXPECT_LT(e.taken.relative_rms, 0.1 * e.kept.relative_rms) << model_info(model).name << " " << m;
            EXPECT_GT(e.taken.display_psnr_db, e.kept.display_psnr_db + 8) << model_info(model).name << " " << m;
        }
}

TEST(Suns, LeaveTheReferenceAlone) {
    const Image sky = burnish_test::sunny_latlong({{{0.5f, 0.6f, 0.4f}}}, 512);
    const Environment kept = Environment::from_image(sky, keeping(), "kept"), taken = Environment::from_image(sky, {}, "taken");
    const Ball ball(8);
    const LobeParameters lobe = round_lobe(ModelId::ggx, 0.1f);
    EXPECT_EQ(ball.shade(lobe, kept, EstimatorKind::reference).overlay.data,
              ball.shade(lobe, taken, EstimatorKind::reference).overlay.data);
}

/// A sun gains much; weak lamps (5 % of the light) little under rough lobes, so there apart must only be no worse.
TEST(Suns, ApartHelpUnderRealSkies) {
    struct Case {
        const char* name;
        float rms_ratio;  // taken over kept, at the most
        double decibels;  // gained, at the least
    };
    for (const Case& c : {Case{"rooitou_park_1k", 0.15f, 10}, Case{"st_fagans_interior_1k", 1.0f, 0}}) {
        const auto file = data_path("public/env/" + std::string(c.name) + ".hdr");
        if (!file) GTEST_SKIP() << "REAL DATA MISSING: public/env, see BURNISH_DATA";
        const Environment kept = Environment::load(file->string(), keeping()), taken = Environment::load(file->string(), {});
        const Ball ball(24);
        for (const ModelId model : {ModelId::beckmann, ModelId::ggx})
            for (const float m : {0.05f, 0.1f, 0.3f}) {
                const KeptAndTaken e = errors(ball, round_lobe(model, m), kept, taken);
                std::printf("%-22s %-8s m %.2f  relative RMS %.4f -> %.4f  display PSNR %.1f -> %.1f dB\n", c.name,
                            model_info(model).name.data(), m, e.kept.relative_rms, e.taken.relative_rms, e.kept.display_psnr_db,
                            e.taken.display_psnr_db);
                EXPECT_LT(e.taken.relative_rms, c.rms_ratio * e.kept.relative_rms) << c.name << " " << m;
                EXPECT_GT(e.taken.display_psnr_db, e.kept.display_psnr_db + c.decibels) << c.name << " " << m;
            }
    }
}

TEST(Suns, AreOnlyFoundWhereTheyAre) {
    for (const auto& [name, count] : {std::pair("dikhololo_night_1k", 0u), std::pair("lebombo_1k", 0u),
                                      std::pair("rooitou_park_1k", 1u), std::pair("studio_small_03_1k", 0u)}) {
        const auto file = data_path("public/env/" + std::string(name) + ".hdr");
        if (!file) GTEST_SKIP() << "REAL DATA MISSING: public/env, see BURNISH_DATA";
        EXPECT_EQ(Environment::load(file->string(), {}).discs().size(), count) << name;
    }
}
