// Error of the few-sample estimators: relative RMS against `reference`, as CSV on standard output.
//
// One row per (model, mx, my, estimator, quadrature, samples, border, level bias, albedo correction), the mean over
// `--lights` stress lights, or over the files of `--lights-from`, on a sphere of `--size` pixels. `burnish_estimator_error --help` lists the sweeps.
#include "bench/estimator_names.h"
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/material/library.h>
#include <burnish/shading/dense.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>

using namespace burnish;

namespace {

struct Sweep {
    float tolerance = 0.002f;
    int size = 96, lights = 8, first_light = 1000, face_size = 512;
    std::vector<std::string> files;
    std::vector<std::string> materials;
    std::string model = "beckmann", kernel = "binomial6";
    std::vector<float> mx{0.02f, 0.05f, 0.1f, 0.15f, 0.3f}, my, biases{-1.0f, -0.75f, -0.5f, -0.25f, 0.0f}, borders{0.0f};
    std::vector<int> samples{19};
    std::vector<std::string> estimators{"fitted", "regular", "filtered_importance"}, quadratures{"half_vector"},
        patterns{"automatic"};
    bool uncorrected = false;
};

const std::map<std::string, ModelId> kModels{{"kurt", ModelId::kurt}, {"beckmann", ModelId::beckmann}, {"ggx", ModelId::ggx}};
const std::map<std::string, PyramidKernel> kKernels{
    {"box2", PyramidKernel::box2}, {"binomial4", PyramidKernel::binomial4}, {"binomial6", PyramidKernel::binomial6}};
const std::map<std::string, Quadrature> kQuadratures{
    {"half_vector", Quadrature::half_vector}, {"energy", Quadrature::energy}, {"energy_squared", Quadrature::energy_squared}};
const std::map<std::string, PatternKind> kPatterns{
    {"automatic", PatternKind::automatic}, {"circles", PatternKind::circles}, {"offset_circles", PatternKind::offset_circles},
    {"ring", PatternKind::ring},           {"rings", PatternKind::rings},     {"line", PatternKind::line},
    {"tuned", PatternKind::tuned}};

/// Root of mean (a - b)^2 over mean b^2, over the shaded pixels seen steeper than `max_cosine`.
double relative_rms(const Image& image, const Image& reference, const Image& cosine, float max_cosine) {
    double square = 0, power = 0;
    for (size_t i = 0; i < image.pixel_count(); ++i) {
        if (*cosine.at(i) <= 0 || *cosine.at(i) > max_cosine) continue;
        const double truth = reference.at(i)[1], d = image.at(i)[1] - truth;
        square += d * d, power += truth * truth;
    }
    return std::sqrt(square / power);
}

constexpr float kGrazing = 0.26f;  // cosine of 75 degrees

/// wo . n of every pixel, 0 where there is no surface.
Image view_cosines(const AovFrame& frame, const Surfaces& surfaces) {
    const Image& normal = frame.layer(Role::normal);
    Image cosine(normal.width, normal.height, 1);
    SurfaceBatch batch;
    surfaces.gather({0, 0, normal.width, normal.height}, 0, batch);
    for (size_t i = 0; i < batch.size(); ++i) *cosine.at(static_cast<size_t>(batch.pixel[i])) = batch.wo[i].dot(batch.n[i]);
    return cosine;
}

class Bench {
public:
    explicit Bench(const Sweep& sweep)
        : m_sweep(sweep),
          m_frame(scenes::sphere_frame(sweep.size)),
          m_assignment(scenes::whole_frame(m_frame)),
          m_surfaces(m_frame, m_assignment, {}),
          m_cosine(view_cosines(m_frame, m_surfaces)) {
        EnvironmentSettings settings;
        settings.face_size = sweep.face_size, settings.kernel = kKernels.at(sweep.kernel);
        for (const std::string& file : sweep.files) m_lights.push_back(Environment::load(file, settings));
        for (int i = 0; i < sweep.lights && sweep.files.empty(); ++i)
            m_lights.push_back(Environment::from_image(scenes::stress_light(sweep.first_light + i, 1024), settings, "stress"));
    }

    void run(float mx, float my) {
        LobeParameters lobe;
        lobe.model = kModels.at(m_sweep.model), lobe.mx = mx, lobe.my = my;
        lobe.extra = {0.0f};
        run(lobe, m_sweep.model);
    }

    /// A material's first lobe.
    void run(const std::string& material) { run(find_material(material).lobes.at(0), material); }

private:
    void run(const LobeParameters& lobe, const std::string& name) {
        m_material.lobes = {lobe}, m_name = name;
        EstimatorSettings settings;
        settings.kind = EstimatorKind::reference, settings.tolerance = m_sweep.tolerance, settings.max_samples = 32768;
        m_references.clear();
        for (const Environment& light : m_lights) m_references.push_back(shade(light, settings));
        for (const std::string& estimator : m_sweep.estimators) sweep_estimator(estimator, lobe);
    }

    ShadedFrame shade(const Environment& light, const EstimatorSettings& settings) const {
        return shade_dense(m_surfaces, m_assignment, {MaterialShader(m_material, light, settings)}, {}, true);
    }

    void sweep_estimator(const std::string& name, const LobeParameters& lobe) const {
        const bool regular = name == "regular", biased = regular || name == "filtered_importance";
        const std::vector<std::string> one{"-"};
        for (const int samples : m_sweep.samples)
            for (const std::string& quadrature : regular ? m_sweep.quadratures : one)
                for (const std::string& pattern : regular ? m_sweep.patterns : one)
                    for (const float border : regular ? m_sweep.borders : std::vector<float>{0})
                        for (const float bias : biased ? m_sweep.biases : std::vector<float>{0}) {
                            EstimatorSettings settings;
                            settings.kind = kEstimators.at(name), settings.samples = samples, settings.level_bias = bias;
                            settings.border = border, settings.albedo_correction = !m_sweep.uncorrected;
                            if (regular)
                                settings.quadrature = kQuadratures.at(quadrature), settings.pattern = kPatterns.at(pattern);
                            double error = 0, grazing = 0, lookups = 0;
                            for (size_t i = 0; i < m_lights.size(); ++i) {
                                const ShadedFrame result = shade(m_lights[i], settings);
                                const Image& truth = m_references[i].overlay;
                                error += relative_rms(result.overlay, truth, m_cosine, 1) / m_lights.size();
                                grazing += relative_rms(result.overlay, truth, m_cosine, kGrazing) / m_lights.size();
                                lookups = *std::max_element(result.samples.data.begin(), result.samples.data.end());
                            }
                            std::printf("%s,%g,%g,%s,%s,%s,%d,%g,%g,%g,%d,%.5f,%.5f\n", m_name.c_str(), lobe.mx, lobe.my,
                                        name.c_str(), quadrature.c_str(), pattern.c_str(), samples, lookups, border, bias,
                                        !m_sweep.uncorrected, error, grazing);
                            std::fflush(stdout);
                        }
    }

    Sweep m_sweep;
    AovFrame m_frame;
    Assignment m_assignment;
    Surfaces m_surfaces;
    Image m_cosine;
    std::vector<Environment> m_lights;
    Material m_material;
    std::string m_name;  // of the model or the material
    std::vector<ShadedFrame> m_references;
};

}  // namespace

int main(int argc, char** argv) {
    Sweep sweep;
    CLI::App app("Relative RMS of the few-sample estimators");
    app.add_option("--size", sweep.size, "sphere diameter in pixels")->capture_default_str();
    app.add_option("--lights", sweep.lights, "number of stress lights")->capture_default_str();
    app.add_option("--first-light", sweep.first_light, "seed of the first stress light")->capture_default_str();
    app.add_option("--lights-from", sweep.files, "environment files instead of stress lights")->delimiter(',');
    app.add_option("--tolerance", sweep.tolerance, "of the reference")->capture_default_str();
    app.add_option("--face-size", sweep.face_size, "texels per cube face edge")->capture_default_str();
    app.add_option("--kernel", sweep.kernel, "box2, binomial4 or binomial6")->capture_default_str();
    app.add_option("--model", sweep.model, "kurt, beckmann or ggx")->capture_default_str();
    app.add_option("--materials", sweep.materials,
                   "in place of a model and its widths: first lobes of presets, merl:NAME or files")
        ->delimiter(',');
    app.add_option("--mx", sweep.mx, "slope widths")->delimiter(',')->capture_default_str();
    app.add_option("--my", sweep.my, "slope widths along the bitangent; default: mx")->delimiter(',');
    app.add_option("--samples", sweep.samples, "lookups")->delimiter(',')->capture_default_str();
    app.add_option("--biases", sweep.biases, "level biases")->delimiter(',')->capture_default_str();
    app.add_option("--borders", sweep.borders, "xi0; 0 = default")->delimiter(',')->capture_default_str();
    app.add_option("--estimators", sweep.estimators, "fitted, regular, filtered_importance, preconvolved, split_sum")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--quadratures", sweep.quadratures, "half_vector, energy, energy_squared")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--patterns", sweep.patterns, "automatic, circles, offset_circles, ring, rings, line, tuned")
        ->delimiter(',')
        ->capture_default_str();
    app.add_flag("--uncorrected", sweep.uncorrected, "without the albedo correction");
    CLI11_PARSE(app, argc, argv);
    std::puts(
        "model,mx,my,estimator,quadrature,pattern,samples,lookups,border,level_bias,corrected,relative_rms,beyond_75_deg");
    Bench bench(sweep);
    for (const std::string& material : sweep.materials) bench.run(material);
    for (size_t i = 0; sweep.materials.empty() && i < sweep.mx.size(); ++i)
        bench.run(sweep.mx[i], i < sweep.my.size() ? sweep.my[i] : sweep.mx[i]);
    return 0;
}
