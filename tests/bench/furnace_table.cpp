// The white furnace as a table: estimated over true directional albedo of the few-sample estimators, in percent, over
// roughness and view angle. `plain`: the bare quadrature; `corrected`: with the tabulated albedo ratio, the default.
//
//     burnish_furnace_table [samples, default 19]
#include "core/scenes.h"

#include <burnish/material/albedo.h>
#include <burnish/shading/material_shader.h>

#include <cstdio>
#include <cstdlib>

using namespace burnish;

namespace {

const std::vector<float> kAngles_deg{0, 30, 45, 60, 70, 75, 80, 85};
const std::vector<float> kWidths{0.02f, 0.05f, 0.1f, 0.2f, 0.3f, 0.5f};

SurfaceBatch points_at(const std::vector<float>& angles_deg) {
    SurfaceBatch batch;
    for (const float angle : angles_deg) {
        const float theta = angle * kPi / 180;
        batch.pixel.push_back(0);
        batch.p.push_back({0, 0, 0}), batch.n.push_back({0, 0, 1}), batch.ng.push_back({0, 0, 1}), batch.t.push_back({1, 0, 0});
        batch.wo.push_back({std::sin(theta), 0, std::cos(theta)});
    }
    return batch;
}

const char* estimator_name(EstimatorKind kind) {
    if (kind == EstimatorKind::fitted) return "fitted";
    if (kind == EstimatorKind::preconvolved) return "preconvolved";
    return kind == EstimatorKind::regular ? "regular" : "filtered_importance";
}

void print_rows(const char* name, const LobeParameters& lobe, const Environment& light, const EstimatorSettings& settings) {
    const SurfaceBatch batch = points_at(kAngles_deg);
    ShadedBatch out;
    MaterialShader({"furnace", Color3f(0, 0, 0), {lobe}}, light, settings).shade(batch, out);
    std::printf("%-8s %-20s %-10s %5.2f", name, estimator_name(settings.kind),
                settings.albedo_correction ? "corrected" : "plain", lobe.mx);
    for (size_t i = 0; i < batch.size(); ++i)
        std::printf(" %7.2f", 100 * (out.overlay[i].y / directional_albedo(lobe, batch.wo[i], 1 << 16).y - 1));
    std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
    EnvironmentSettings plain;
    plain.face_size = 16;
    const Environment light = Environment::from_image(scenes::constant_light(1), plain, "constant");
    std::printf("%-8s %-20s %-10s %5s", "lobe", "estimator", "albedo", "m");
    for (const float angle : kAngles_deg) std::printf(" %4.0f deg", angle);
    std::printf("\n");
    for (const ModelId model : {ModelId::kurt, ModelId::beckmann, ModelId::ggx})
        for (const EstimatorKind kind :
             {EstimatorKind::fitted, EstimatorKind::regular, EstimatorKind::filtered_importance, EstimatorKind::preconvolved})
            for (const bool corrected : {false, true})
                for (const float m : kWidths) {
                    LobeParameters lobe;
                    lobe.model = model, lobe.mx = lobe.my = m;
                    if (model == ModelId::kurt) lobe.extra = {0.0f};
                    EstimatorSettings settings;
                    settings.kind = kind, settings.albedo_correction = corrected;
                    settings.samples = argc > 1 ? std::atoi(argv[1]) : 0;
                    print_rows(model == ModelId::kurt  ? "kurt a=0"
                               : model == ModelId::ggx ? "ggx"
                                                       : "beckmann",
                               lobe, light, settings);
                }
    return 0;
}
