// Sparse against dense shading with the same estimator: time, display PSNR, pixels shaded and what an oracle would shade, as CSV
// on standard output. One row per (light, frame, model, m): spheres of some radii in a frame of `--height` pixels, or the hard
// cases of hard_cases.h.
#include "bench/hard_cases.h"
#include "core/scenes.h"

#include <burnish/base/parallel.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <map>

using namespace burnish;

namespace {

struct Table {
    HardSettings frame;
    int threads = 1;
    std::vector<int> radii{400, 120, 60};
    std::vector<float> widths{0.01f, 0.03f, 0.1f, 0.2f, 0.4f};
    std::vector<std::string> lights, hard;
    std::string model = "ggx", estimator = "fitted", pictures;
    SparseSettings settings;
};

const std::map<std::string, ModelId> kModels{{"kurt", ModelId::kurt}, {"beckmann", ModelId::beckmann}, {"ggx", ModelId::ggx}};
const std::map<std::string, EstimatorKind> kEstimators{{"fitted", EstimatorKind::fitted},
                                                       {"regular", EstimatorKind::regular},
                                                       {"filtered_importance", EstimatorKind::filtered_importance},
                                                       {"reference", EstimatorKind::reference}};

void add_options(CLI::App& app, Table& table) {
    app.add_option("--height", table.frame.height, "of the frame, pixels; 16:9");
    app.add_option("--radii", table.radii, "of the sphere at 1080 lines, pixels; scaled to the height");
    app.add_option("--hard", table.hard, "hard cases instead of spheres, or all");
    app.add_option("--m", table.widths, "slope widths");
    app.add_option("--lights", table.lights, "environment maps; none: a stress light");
    app.add_option("--model", table.model);
    app.add_option("--estimator", table.estimator);
    app.add_option("--samples", table.settings.estimator.samples);
    app.add_option("--max-samples", table.settings.estimator.max_samples, "of the reference");
    app.add_option("--tolerance", table.settings.estimator.tolerance, "of the reference");
    app.add_option("--directions", table.settings.density.directions);
    app.add_option("--safety", table.settings.density.safety);
    app.add_option("--repeats", table.settings.repeats);
    app.add_flag("--with-regular", table.settings.with_regular, "times dense regular, n = 16, too");
    app.add_option("--threads", table.threads);
    app.add_option("--pictures", table.pictures, "folder for pictures of each row");
}

SparseCase sphere_case(const Table& table, int radius, float m) {
    const int height = table.frame.height;
    SparseCase made;
    made.name = std::to_string(radius);
    made.frame = scenes::sphere_in_frame(height * 16 / 9, height, radius * height / 1080);
    made.assignment = scenes::whole_frame(made.frame);
    made.materials = {{"bench", Color3f(0, 0, 0), {scenes::lobe_of(table.frame.model, m, m)}}};
    return made;
}

void print_row(const Table& table, const std::string& light_name, const SparseCase& what, const Environment& light, float m) {
    char row[256];
    std::snprintf(row, sizeof row, "%s_%s_%s_%g", light_name.c_str(), what.name.c_str(), table.model.c_str(), m);
    const std::string prefix = table.pictures.empty() ? "" : table.pictures + "/" + row;
    const SparseFigures f = measure_sparse(what, light, table.settings, prefix);
    std::printf("%s,%s,%s,%g,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.1f,%.2f,%.2f,%.2f,%d %d\n", light_name.c_str(), what.name.c_str(),
                table.model.c_str(), m, f.dense_ms, f.sparse_ms, f.dense_ms / f.sparse_ms, f.turning_ms, f.plan_ms,
                f.regular_ms / (f.turning_ms + f.plan_ms), f.psnr_db, 100 * f.shaded, 100 * f.oracle, f.shaded / f.oracle,
                f.worst_x, f.worst_y);
    std::fflush(stdout);
}

void print_rows(const Table& table, const std::string& name, const Environment& light) {
    for (HardSettings settings = table.frame; const float m : table.widths) {
        settings.m = m;
        for (const std::string& hard : table.hard) print_row(table, name, hard_case(hard, settings), light, m);
        if (table.hard.empty())
            for (const int radius : table.radii) print_row(table, name, sphere_case(table, radius, m), light, m);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Table table;
    CLI::App app("Sparse against dense shading.");
    add_options(app, table);
    CLI11_PARSE(app, argc, argv);
    table.frame.model = kModels.at(table.model);
    table.settings.estimator.kind = kEstimators.at(table.estimator);
    if (table.hard == std::vector<std::string>{"all"}) table.hard.assign(hard_case_names().begin(), hard_case_names().end());
    const ThreadLimit limit(table.threads);
    std::printf(
        "light,frame,model,m,dense_ms,sparse_ms,ratio,turning_ms,plan_ms,regular16_over_prediction,psnr_db,"
        "shaded_%%,oracle_%%,over_oracle,worst\n");
    for (const std::string& file : table.lights)
        print_rows(table, std::filesystem::path(file).stem().string(), Environment::load(file, {}));
    if (table.lights.empty()) print_rows(table, "stress", Environment::from_image(scenes::stress_light(1), {}, "stress"));
}
