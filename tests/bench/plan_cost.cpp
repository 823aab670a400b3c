// Predicted against measured seconds of a dozen configurations, with the constants that plans take on this machine; prints CSV,
// milliseconds by the clock, the least of some runs.
//
//     burnish calibrate && burnish_plan_cost
#include "core/scenes.h"

#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/material/library.h>
#include <burnish/plan/cost_model.h>
#include <burnish/shading/sparse.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace burnish;

namespace {

constexpr int kWidth = 960, kHeight = 540, kRadius = 250, kFace = 256;

struct Case {
    const char* name;
    LobeParameters lobe;
    Configuration configuration;
    float safety = 0;
};

std::vector<Case> cases() {
    using enum EstimatorKind;
    const LobeParameters ggx = scenes::lobe_of(ModelId::ggx, 0.1f, 0.1f), rough = scenes::lobe_of(ModelId::ggx, 0.4f, 0.4f);
    const LobeParameters beckmann = scenes::lobe_of(ModelId::beckmann, 0.1f, 0.1f);
    const LobeParameters turned = scenes::lobe_of(ModelId::ggx, 0.3f, 0.05f), brass = find_material("merl:brass").lobes[0];
    LobeParameters layered = ggx;
    layered.per_pixel.roughness = true;
    return {{"ggx 0.1", ggx, {regular, 7}},
            {"ggx 0.1", ggx, {regular, 61}},
            {"ggx 0.1", ggx, {filtered_importance, 64}},
            {"ggx 0.1", ggx, {filtered_importance, 512}},
            {"ggx 0.1", ggx, {fitted, 2}},
            {"ggx 0.1", ggx, {fitted, 6}},
            {"ggx 0.4", rough, {fitted, 16}},
            {"ggx 0.4", rough, {fitted, 6}, 2},
            {"ggx 0.1", ggx, {regular, 61}, 1},
            {"ggx 0.1", ggx, {filtered_importance, 256}, 0.5f},
            {"beckmann 0.1", beckmann, {regular, 19}},
            {"beckmann 0.1", beckmann, {fitted, 4}},
            {"ggx 0.3 x 0.05", turned, {regular, 19}},
            {"ggx 0.3 x 0.05", turned, {fitted, 6}},
            {"ggx 0.3 x 0.05", turned, {filtered_importance, 256}},
            {"ggx, roughness from a layer", layered, {fitted, 4}},
            {"brass (sgd)", brass, {regular, 19}},
            {"brass (sgd)", brass, {fitted, 6}}};
}

/// A sphere under a light that nothing was made of yet.
class Subject {
public:
    PredictedCost measured(const Case& one) const {
        const Environment light = Environment::from_image(m_picture, m_settings, "stress");
        const Material material{one.name, Color3f(0, 0, 0), {one.lobe}};
        const EstimatorSettings settings = with({}, one.configuration);
        std::vector<MaterialShader> shaders;
        std::vector<BandwidthPredictor> predictors;
        PredictedCost cost;
        cost.light = seconds([&] {
            if (settings.kind != EstimatorKind::fitted) light.pyramid();
            if (settings.kind == EstimatorKind::fitted || one.safety > 0) light.gaussian_stack().stack();
        });
        cost.tables = seconds([&] {
            shaders.emplace_back(material, light, settings);
            DensitySettings density;
            density.safety = one.safety;
            if (one.safety > 0) predictors.emplace_back(material, light, density);
        });
        cost.shading = seconds([&] {
            if (one.safety > 0)
                shade_sparse(m_frame, m_surfaces, m_assignment, shaders, predictors, {});
            else
                shade_dense(m_surfaces, m_assignment, shaders, {});
        });
        return cost;
    }

    PredictedCost predicted(const Case& one) const {
        CostCase of;
        of.pixels = m_surfaces.rule_counts()[0], of.frame_pixels = static_cast<size_t>(kWidth) * kHeight;
        of.face_texels = 6 * kFace * kFace;
        return predicted_cost(machine_costs(), {"", Color3f(0, 0, 0), {one.lobe}}, one.configuration, one.safety, of);
    }

private:
    template <class Work>
    static double seconds(Work&& work) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    Image m_picture = scenes::stress_light(1);
    EnvironmentSettings m_settings{.face_size = kFace};
    AovFrame m_frame = scenes::sphere_in_frame(kWidth, kHeight, kRadius);
    Assignment m_assignment = scenes::whole_frame(m_frame);
    Surfaces m_surfaces{m_frame, m_assignment, {}};
};

const char* name_of(EstimatorKind kind) {
    return kind == EstimatorKind::fitted ? "fitted" : kind == EstimatorKind::regular ? "regular" : "filtered_importance";
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::atoi(argv[1]) : 5;
    const Subject scene;
    std::printf(
        "lobe,estimator,lookups,safety,light,tables,shading,predicted_light,predicted_tables,predicted_shading,ratio\n");
    for (const Case& one : cases()) {
        PredictedCost least{1e30, 1e30, 1e30};
        for (int run = 0; run < runs; ++run) {
            const PredictedCost found = scene.measured(one);
            least = {std::min(least.light, found.light), std::min(least.tables, found.tables),
                     std::min(least.shading, found.shading)};
        }
        const PredictedCost expected = scene.predicted(one);
        std::printf("%s,%s,%d,%g,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f\n", one.name, name_of(one.configuration.estimator),
                    one.configuration.samples, one.safety, 1e3 * least.light, 1e3 * least.tables, 1e3 * least.shading,
                    1e3 * expected.light, 1e3 * expected.tables, 1e3 * expected.shading, expected.total() / least.total());
        std::fflush(stdout);
    }
    return 0;
}
