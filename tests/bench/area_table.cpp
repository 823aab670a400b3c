// Estimators under area lights against brute force: prints CSV.
#include "area_cases.h"

#include <burnish/base/parallel.h>
#include <burnish/material/lobe.h>
#include <burnish/output/compare.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>

using namespace burnish;
namespace burnish { extern float kFine, kCoarse, kFineQ, kCoarseQ; extern bool kFocus; }

namespace {

LobeParameters lobe_of(ModelId model, float m) {
    LobeParameters lobe;
    lobe.model = model, lobe.mx = lobe.my = m;
    return lobe;
}

EstimatorSettings estimator(EstimatorKind kind, int samples) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples;
    settings.tolerance = 0.001f, settings.max_samples = 1 << 15;
    return settings;
}

struct Shaded {
    Image picture;
    double us, samples;
    std::vector<float> error;
};

Image picture_of(const std::vector<Color3f>& colors) {
    Image image(static_cast<int>(colors.size()), 1, 3);
    for (size_t i = 0; i < colors.size(); ++i) std::copy_n(&colors[i].x, 3, image.at(i));
    return image;
}

Shaded shade(const LobeParameters& lobe, const EstimatorSettings& settings, const LightChain& chain, const SurfaceBatch& batch, int runs) {
    const MaterialShader shader(std::make_shared<const MaterialTaps>(Material{"", Color3f(0), {lobe}}, settings), chain);
    ShadedBatch out;
    double best = 1e9;
    for (int run = 0; run < runs; ++run) {
        const auto start = std::chrono::steady_clock::now();
        shader.shade(batch, out);
        best = std::min(best, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
    double samples = 0;
    for (float s : out.samples) samples += s;
    const double n = static_cast<double>(batch.size());
    return {picture_of(out.overlay), best / n, samples / n, out.standard_error};
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<float> widths{0.02f, 0.05f, 0.1f, 0.2f, 0.5f};
    std::vector<std::string> models{"ggx"};
    std::vector<float> fines{0.6f};
    std::vector<int> taps{7};
    int columns = 40, rows = 26;
    float q = 0;
    bool textured = false, solid = true;
    CLI::App app;
    app.add_option("--q", q);
    app.add_option("--focus", kFocus);
    app.add_option("--m", widths)->delimiter(',');
    app.add_option("--model", models)->delimiter(',');
    app.add_option("--fine", fines)->delimiter(',');
    app.add_option("--taps", taps)->delimiter(',');
    app.add_option("--columns", columns);
    app.add_option("--rows", rows);
    app.add_flag("--textured", textured);
    CLI11_PARSE(app, argc, argv);
    for (const std::string& model : models)
        for (const auto& lamp : area_cases::lamps(textured))
            for (int object = 0; object < 2; ++object)
                for (float m : widths) {
                    const SurfaceBatch batch = object ? area_cases::sphere_view(columns, rows) : area_cases::floor_view(columns, rows);
                    const LobeParameters lobe = lobe_of(model == "ggx" ? ModelId::ggx : model == "kurt" ? ModelId::kurt : ModelId::beckmann, m);
                    LightChain chain({{std::make_shared<const Light>(AreaLight(lamp.settings, Color3f(1), lamp.picture)), false}});
                    const Shaded truth = shade(lobe, estimator(EstimatorKind::reference, 0), chain, batch, 1);
                    printf("%s,%s,%s,%.2f", model.c_str(), object ? "sphere" : "floor", lamp.name.c_str(), m);
                    for (int n : taps)
                        for (float fine : fines) {
                            kFine = fine, kCoarse = 2 * fine, kFineQ = q * fine, kCoarseQ = std::max(2 * q, 1e-3f) * fine;
                            const Shaded s = shade(lobe, estimator(EstimatorKind::fitted, n), chain, batch, 3);
                            if (getenv("DUMP")) { std::vector<std::pair<float,size_t>> e; for (size_t i=0;i<batch.size();++i) e.push_back({std::fabs(s.picture.at(i)[1]-truth.picture.at(i)[1]),i}); std::sort(e.rbegin(),e.rend()); for(int k=0;k<8;++k){size_t i=e[k].second; printf("\n   #%zu p %.2f %.2f %.2f wo.n %.3f got %.4g truth %.4g +- %.2g",i,batch.p.x[i],batch.p.y[i],batch.p.z[i],batch.wo[i].dot(batch.n[i]),s.picture.at(i)[1],truth.picture.at(i)[1],truth.error[i]);} printf("\n");}
                            const Comparison c = compare_images(s.picture, truth.picture, nullptr);
                            printf(" | %d,%.2f: %.1f dB %.4f %.2f us %.1f", n, fine, c.display_psnr_db, c.relative_rms, s.us, s.samples);
                        }
                    printf("\n"), fflush(stdout);
                }
}
