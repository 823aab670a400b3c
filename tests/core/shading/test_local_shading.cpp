// Shading through a chain of lights: where that is distant light alone, it must agree with the kernels made for it.
#include "shading_cases.h"

#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

std::shared_ptr<const Environment> stress() {
    return std::make_shared<const Environment>(light_of(scenes::stress_light(3, 256)));
}

LightChain chain_of(std::initializer_list<std::shared_ptr<const Environment>> environments, bool blocks) {
    std::vector<LightChain::Link> links;
    for (const auto& environment : environments)
        links.push_back({std::make_shared<const Light>(EnvironmentLight(environment)), blocks});
    return LightChain(links);
}

ShadedBatch shade_by(const LightChain& lights, const LobeParameters& p, const EstimatorSettings& settings,
                     const SurfaceBatch& batch) {
    ShadedBatch out;
    MaterialShader(std::make_shared<const MaterialTaps>(material(p), settings), lights).shade(batch, out);
    return out;
}

/// Largest difference over the largest value.
float difference(const ShadedBatch& a, const ShadedBatch& b) {
    float largest = 0, most = 0;
    for (size_t i = 0; i < a.overlay.size(); ++i) {
        most = std::max(most, luminance(b.overlay[i]));
        largest = std::max(largest, std::fabs(luminance(a.overlay[i] - b.overlay[i])));
    }
    return largest / most;
}

}  // namespace

TEST(LocalShading, AgreesWithTheKernelsOfDistantLight) {
    const auto light = stress();
    for (const EstimatorKind kind : {EstimatorKind::fitted, EstimatorKind::preconvolved}) {
        const EstimatorSettings settings = estimator(kind, 8);
        for (const LobeParameters& p : {lobe(ModelId::ggx, 0.2f, 0.2f), lobe(ModelId::beckmann, 0.1f, 0.3f)}) {
            const ShadedBatch distant = shade(material(p), *light, settings, fan(0.7f));
            EXPECT_LT(difference(shade_by(chain_of({light}, false), p, settings, fan(0.7f)), distant), 0.01f);
        }
    }
}

TEST(LocalShading, ReferenceTakesTheSameSamples) {
    const auto light = stress();
    EstimatorSettings settings = estimator(EstimatorKind::reference);
    settings.max_samples = 2048;
    const LobeParameters p = lobe(ModelId::ggx, 0.2f, 0.2f);
    const ShadedBatch distant = shade(material(p), *light, settings, fan(0.7f));
    const ShadedBatch local = shade_by(chain_of({light}, false), p, settings, fan(0.7f));
    EXPECT_LT(difference(local, distant), 1e-4f);
    EXPECT_EQ(local.samples, distant.samples);
}

TEST(LocalShading, LightsAddAndBlockingOnesHide) {
    const auto light = stress();
    const EstimatorSettings settings = estimator(EstimatorKind::fitted, 6);
    const LobeParameters p = lobe(ModelId::ggx, 0.2f, 0.2f);
    const ShadedBatch one = shade_by(chain_of({light}, false), p, settings, fan(0.7f));
    const ShadedBatch both = shade_by(chain_of({light, light}, false), p, settings, fan(0.7f));
    const ShadedBatch hidden = shade_by(chain_of({light, light}, true), p, settings, fan(0.7f));
    for (size_t i = 0; i < one.overlay.size(); ++i) {
        EXPECT_NEAR(luminance(both.overlay[i]), 2 * luminance(one.overlay[i]), 1e-4f * luminance(one.overlay[i]));
        EXPECT_EQ(luminance(hidden.overlay[i]), luminance(one.overlay[i]));
    }
}
