// Lobes under area lights against brute force, as CSV: `fitted` as it is, its taps alone (no lamp sampled directly), and, for round lobes
// under solid lamps, linearly transformed cosines. Display PSNR, RMS error over mean, microseconds a pixel, lookups a pixel.
//
//     burnish_area_table --model ggx,beckmann,kurt --m 0.02,0.05,0.1,0.2,0.5 [--textured] [--taps 7]
#include "area_cases.h"
#include "ltc.h"

#include <burnish/output/compare.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <functional>

using namespace burnish;

namespace {

constexpr int kRuns = 5;

ModelId model_of(const std::string& name) {
    return name == "ggx" ? ModelId::ggx : name == "kurt" ? ModelId::kurt : ModelId::beckmann;
}

EstimatorSettings estimator(EstimatorKind kind, int samples) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples, settings.tolerance = 0.001f, settings.max_samples = 1 << 15;
    return settings;
}

Image picture_of(const std::vector<Color3f>& colors) {
    Image image(static_cast<int>(colors.size()), 1, 3);
    for (size_t i = 0; i < colors.size(); ++i) std::copy_n(&colors[i].x, 3, image.at(i));
    return image;
}

/// Microseconds a pixel, the least of a few runs.
double time_of(size_t pixels, const std::function<void()>& work) {
    double best = 1e30;
    for (int run = 0; run < kRuns; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        best = std::min(best, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
    return best / static_cast<double>(pixels);
}

struct Case {
    std::string name;
    const area_cases::Lamp& lamp;
    LobeParameters lobe;
    SurfaceBatch batch;
    Image truth = {};

    LightChain lights() const {
        return LightChain({{std::make_shared<const Light>(AreaLight(lamp.settings, Color3f(1), lamp.picture)), false}});
    }
    ShadedBatch shaded(const EstimatorSettings& settings) const {
        ShadedBatch out;
        MaterialShader(std::make_shared<const MaterialTaps>(Material{"", Color3f(0), {lobe}}, settings), lights())
            .shade(batch, out);
        return out;
    }
    void print(const char* method, const std::vector<Color3f>& overlay, double us, double lookups) const {
        const Comparison c = compare_images(picture_of(overlay), truth, nullptr);
        std::printf("%s,%.3g,%s,%.1f,%.4f,%.2f,%.1f\n", name.c_str(), static_cast<double>(lobe.mx), method, c.display_psnr_db,
                    c.relative_rms, us, lookups);
        std::fflush(stdout);
    }
};

void print_fitted(const Case& c, int taps) {
    const MaterialShader shader(
        std::make_shared<const MaterialTaps>(Material{"", Color3f(0), {c.lobe}}, estimator(EstimatorKind::fitted, taps)),
        c.lights());
    ShadedBatch out;
    const double us = time_of(c.batch.size(), [&] { shader.shade(c.batch, out); });
    double lookups = 0;
    for (const float count : out.samples) lookups += count / static_cast<double>(c.batch.size());
    c.print("fitted", out.overlay, us, lookups);
}

/// Taps as rays into the lamp, nothing else.
void print_taps(const Case& c, int taps) {
    const LobeTaps lobe(c.lobe, estimator(EstimatorKind::fitted, taps));
    const AreaLight light(c.lamp.settings, Color3f(1), c.lamp.picture);
    std::vector<Color3f> overlay(c.batch.size());
    std::vector<Tap> list;
    const double us = time_of(c.batch.size(), [&] {
        std::vector<LightRay> rays;
        std::vector<Color3f> weights;
        std::vector<Incident> found;
        for (size_t i = 0; i < c.batch.size(); ++i) {
            const ShadingPoint point = shading_point(c.batch, i, c.lobe, Matrix33f());
            lobe.at(point, list);
            rays.clear(), weights.clear();
            for (const Tap& tap : list) {
                rays.push_back({c.batch.p[i], c.batch.n[i], point.frame.to_world(tap.wi.normalized()), std::exp(tap.level)});
                weights.push_back(tap.weight);
            }
            found.resize(rays.size());
            light.lookup(rays, found);
            overlay[i] = Color3f(0);
            for (size_t k = 0; k < rays.size(); ++k) overlay[i] += weights[k] * found[k].radiance;
        }
    });
    c.print("taps alone", overlay, us, taps);
}

void print_ltc(const Case& c) {
    const LinearlyTransformedCosines table(c.lobe);
    const ConvexPolygon polygon(c.lamp.settings.corners);
    std::vector<Color3f> overlay(c.batch.size());
    const double us = time_of(c.batch.size(), [&] {
        for (size_t i = 0; i < c.batch.size(); ++i) {
            const bool lit = polygon.height(c.batch.p[i]) > 0;
            overlay[i] =
                c.lamp.settings.radiance * (lit ? table.shade(polygon, c.batch.p[i], c.batch.n[i], c.batch.wo[i]) : 0.0f);
        }
    });
    c.print("ltc", overlay, us, 0);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<float> widths{0.02f, 0.05f, 0.1f, 0.2f, 0.5f};
    std::vector<std::string> models{"ggx"};
    int taps = 7, columns = 24, rows = 16;
    bool textured = false;
    CLI::App app{"Area lights against brute force"};
    app.add_option("--m", widths, "slope widths")->delimiter(',');
    app.add_option("--model", models, "ggx, beckmann, kurt")->delimiter(',');
    app.add_option("--taps", taps, "of `fitted`");
    app.add_option("--columns", columns);
    app.add_option("--rows", rows);
    app.add_flag("--textured", textured, "lamps with a picture");
    CLI11_PARSE(app, argc, argv);
    std::printf("model,object,lamp,m,method,psnr,relative rms,us,lookups\n");
    const std::vector<area_cases::Lamp> lamps = area_cases::lamps(textured);
    for (const std::string& model : models)
        for (const area_cases::Lamp& lamp : lamps)
            for (const bool sphere : {false, true})
                for (const float m : widths) {
                    LobeParameters lobe;
                    lobe.model = model_of(model), lobe.mx = lobe.my = m;
                    Case c{model + (sphere ? ",sphere," : ",floor,") + lamp.name, lamp, lobe,
                           sphere ? area_cases::sphere_view(columns, rows) : area_cases::floor_view(columns, rows)};
                    c.truth = picture_of(c.shaded(estimator(EstimatorKind::reference, 0)).overlay);
                    print_fitted(c, taps);
                    print_taps(c, taps);
                    if (!textured) print_ltc(c);
                }
}
