// Measured tables under the few-sample estimators, against `reference`: display PSNR on a sphere, as CSV on standard output.
//
// One row per material, estimator and light. The tables are published fits to MERL's, tabulated (published_fits.h). What is shaded is the
// view-dependent part, the overlay.
#include "bench/estimator_names.h"
#include "core/scenes.h"
#include "published_fits.h"

#include <burnish/base/parallel.h>
#include <burnish/material/measured/merl_table.h>
#include <burnish/material/measured/table_files.h>
#include <burnish/output/compare.h>
#include <burnish/shading/dense.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <map>

using namespace burnish;

namespace {

const std::map<std::string, PatternKind> kPatterns{
    {"automatic", PatternKind::automatic}, {"circles", PatternKind::circles}, {"tuned", PatternKind::tuned}};

struct Sweep {
    int size = 96;
    float tolerance = 0.002f;
    std::string neural, gamma, pattern = "automatic";
    std::vector<std::string> lights, materials, estimators{"regular", "fitted"};
    std::vector<int> samples{0};
    std::vector<float> ggx;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class Bench {
public:
    explicit Bench(const Sweep& sweep)
        : m_sweep(sweep),
          m_frame(scenes::sphere_frame(sweep.size)),
          m_assignment(scenes::whole_frame(m_frame)),
          m_surfaces(m_frame, m_assignment, {}),
          m_mask(sweep.size, sweep.size, 1) {
        SurfaceBatch batch;
        m_surfaces.gather({0, 0, sweep.size, sweep.size}, 0, batch);
        for (const auto pixel : batch.pixel) *m_mask.at(static_cast<size_t>(pixel)) = 1;
        for (const std::string& file : sweep.lights) m_lights.push_back(Environment::load(file, {}));
        std::printf("material,from,m,kd,seconds_to_build,estimator,samples,light,display_db,relative_rms\n");
    }

    template <class F>
    void run(const std::string& name, const char* from, const F& f) const {
        const auto table = std::make_shared<const MerlTable>(f);
        const auto start = std::chrono::steady_clock::now();
        const Material material = table_material(table, name);
        compare(material, from, seconds_since(start));
    }

    /// The estimators on any material, `seconds` of which went into building it.
    void compare(const Material& material, const char* from, double seconds) const {
        for (size_t light = 0; light < m_lights.size(); ++light) {
            EstimatorSettings exact;
            exact.kind = EstimatorKind::reference, exact.tolerance = m_sweep.tolerance, exact.max_samples = 32768;
            const Image truth = shade(material, m_lights[light], exact);
            for (const std::string& estimator : m_sweep.estimators)
                for (const int samples : m_sweep.samples) {
                    EstimatorSettings settings;
                    settings.kind = kEstimators.at(estimator), settings.samples = samples;
                    settings.pattern = kPatterns.at(m_sweep.pattern);
                    const Comparison found = compare_images(shade(material, m_lights[light], settings), truth, &m_mask);
                    std::printf("%s,%s,%.4f,%.3f,%.3f,%s,%d,%s,%.2f,%.4f\n", material.name.c_str(), from, material.lobes[0].mx,
                                material.kd.y, seconds, estimator.c_str(), lookup_count(settings),
                                m_sweep.lights[light].c_str(), found.display_psnr_db, found.relative_rms);
                    std::fflush(stdout);
                }
        }
    }

private:
    Image shade(const Material& material, const Environment& light, const EstimatorSettings& settings) const {
        return shade_dense(m_surfaces, m_assignment, {MaterialShader(material, light, settings)}, {}, false).overlay;
    }

    Sweep m_sweep;
    AovFrame m_frame;
    Assignment m_assignment;
    Surfaces m_surfaces;
    Image m_mask;
    std::vector<Environment> m_lights;
};

bool is_wanted(const Sweep& sweep, const std::string& material) {
    return sweep.materials.empty() || std::ranges::find(sweep.materials, material) != sweep.materials.end();
}

}  // namespace

int main(int argc, char** argv) {
    Sweep sweep;
    CLI::App app("Display PSNR of measured tables under the few-sample estimators");
    app.add_option("--neural", sweep.neural, "nbrdf_merl_80.csv");
    app.add_option("--sgd", sweep.gamma, "sgd_bagher2012.csv");
    app.add_option("--materials", sweep.materials, "names; default: all")->delimiter(',');
    app.add_option("--lights-from", sweep.lights, "environment files")->delimiter(',')->required();
    app.add_option("--size", sweep.size, "sphere diameter in pixels")->capture_default_str();
    app.add_option("--tolerance", sweep.tolerance, "of the reference")->capture_default_str();
    app.add_option("--estimators", sweep.estimators, "regular, fitted, ...")->delimiter(',')->capture_default_str();
    app.add_option("--samples", sweep.samples, "lookups; 0 = default")->delimiter(',')->capture_default_str();
    app.add_option("--ggx", sweep.ggx, "widths of plain GGX lobes to compare with")->delimiter(',');
    app.add_option("--pattern", sweep.pattern, "of regular: automatic, circles or tuned")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    const Bench bench(sweep);
    for (const float m : sweep.ggx) bench.compare({"ggx", Color3f(0), {scenes::lobe_of(ModelId::ggx, m, m)}}, "model", 0);
    if (!sweep.neural.empty())
        for (const published::Row& row : published::read_rows(sweep.neural))
            if (is_wanted(sweep, row.material)) bench.run(row.material, "neural", published::Neural(row));
    if (!sweep.gamma.empty())
        for (const published::Row& row : published::read_rows(sweep.gamma))
            if (is_wanted(sweep, row.material)) bench.run(row.material, "sgd", published::ShiftedGamma(row));
}
