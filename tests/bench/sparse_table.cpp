// Sparse against dense shading with the same estimator: time, display PSNR, pixels shaded and what an oracle would shade, as CSV
// on standard output. One row per (light, radius, model, m): a sphere in a frame of `--height` pixels.
#include "bench/sparse_oracle.h"
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/output/compare.h>
#include <burnish/shading/shading_plan.h>
#include <burnish/shading/sparse.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>

using namespace burnish;

namespace {

struct Table {
    int height = 1080, samples = 0, repeats = 5, threads = 1;
    std::vector<int> radii{400, 120, 60};
    std::vector<float> widths{0.01f, 0.03f, 0.1f, 0.2f, 0.4f};
    std::vector<std::string> lights;
    std::string model = "ggx", estimator = "fitted";
    DensitySettings density;
};

const std::map<std::string, ModelId> kModels{{"kurt", ModelId::kurt}, {"beckmann", ModelId::beckmann}, {"ggx", ModelId::ggx}};
const std::map<std::string, EstimatorKind> kEstimators{{"fitted", EstimatorKind::fitted},
                                                       {"regular", EstimatorKind::regular},
                                                       {"filtered_importance", EstimatorKind::filtered_importance}};

/// The least wall time of some runs, milliseconds.
template <class Work>
double milliseconds(int repeats, Work&& work) {
    double least = 1e30;
    for (int i = 0; i < repeats; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        least = std::min(least, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    return least;
}

Image valid_mask(const Surfaces& surfaces, const Assignment& assignment) {
    Image mask(assignment.width, assignment.height, 1);
    for (size_t i = 0; i < mask.pixel_count(); ++i) mask.data[i] = surfaces.validity(i) == Validity::valid;
    return mask;
}

void print_row(const Table& table, const std::string& name, const AovFrame& frame, int radius, const Environment& light,
               float m) {
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const Material material{"bench", Color3f(0, 0, 0), {scenes::lobe_of(kModels.at(table.model), m, m)}};
    EstimatorSettings settings;
    settings.kind = kEstimators.at(table.estimator), settings.samples = table.samples;
    const std::vector<MaterialShader> shaders{MaterialShader(material, light, settings)};
    const std::vector<BandwidthPredictor> predictors{BandwidthPredictor(material, light, table.density)};

    ShadedFrame dense, sparse;
    const double dense_ms = milliseconds(table.repeats, [&] { dense = shade_dense(surfaces, assignment, shaders, {}); });
    const double sparse_ms =
        milliseconds(table.repeats, [&] { sparse = shade_sparse(frame, surfaces, assignment, shaders, predictors, {}); });
    const double turning_ms = milliseconds(table.repeats, [&] { CellTurning(frame, surfaces, assignment, {}); });
    const CellTurning turning(frame, surfaces, assignment, {});
    const double plan_ms = milliseconds(table.repeats, [&] { ShadingPlan(turning, surfaces, assignment, predictors); });

    const Image mask = valid_mask(surfaces, assignment);
    const double valid = static_cast<double>(surfaces.counts()[0]);
    const auto shaded = static_cast<double>(std::ranges::count_if(
        shade_sparse(frame, surfaces, assignment, shaders, predictors, {}, true).samples.data, [](float n) { return n > 0; }));
    const Comparison error = compare_images(sparse.overlay, dense.overlay, &mask);
    const double oracle = static_cast<double>(oracle_pixels(dense.overlay, mask));
    std::printf("%s,%d,%s,%g,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.2f,%.2f,%.2f\n", name.c_str(), radius, table.model.c_str(), m,
                dense_ms, sparse_ms, dense_ms / sparse_ms, turning_ms, plan_ms, error.display_psnr_db, 100 * shaded / valid,
                100 * oracle / valid, shaded / oracle);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    Table table;
    CLI::App app("Sparse against dense shading.");
    app.add_option("--height", table.height, "of the frame, pixels; 16:9");
    app.add_option("--radii", table.radii, "of the sphere at 1080 lines, pixels; scaled to the height");
    app.add_option("--m", table.widths, "slope widths");
    app.add_option("--lights", table.lights, "environment maps; none: a stress light");
    app.add_option("--model", table.model);
    app.add_option("--estimator", table.estimator);
    app.add_option("--samples", table.samples);
    app.add_option("--directions", table.density.directions);
    app.add_option("--safety", table.density.safety);
    app.add_option("--repeats", table.repeats);
    app.add_option("--threads", table.threads);
    CLI11_PARSE(app, argc, argv);
    const ThreadLimit limit(table.threads);
    std::printf("light,radius,model,m,dense_ms,sparse_ms,ratio,turning_ms,plan_ms,psnr_db,shaded_%%,oracle_%%,over_oracle\n");
    const int width = table.height * 16 / 9;
    for (const int radius : table.radii) {
        const AovFrame frame = scenes::sphere_in_frame(width, table.height, radius * table.height / 1080);
        const auto rows = [&](const std::string& name, const Environment& light) {
            for (const float m : table.widths) print_row(table, name, frame, radius, light, m);
        };
        for (const std::string& file : table.lights)
            rows(std::filesystem::path(file).stem().string(), Environment::load(file, {}));
        if (table.lights.empty()) rows("stress", Environment::from_image(scenes::stress_light(1), {}, "stress"));
    }
}
