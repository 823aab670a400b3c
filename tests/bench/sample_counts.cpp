// What adaptive sample counts save, how good their prediction is, and what a lookup costs: three tables, as CSV.
//
// variance  per light and lobe, over the pixels of a sphere: rank correlation of predictions with the brute-force variance of the
//           integrand, sampled by the lobe or uniformly, and the share of pixels predicted at less than half of it. `moments` is what
//           adaptive shading uses; `bandwidth` and `preconvolved` are the sums of Bandwidth IV.9 and IV.10 over 16 directions, known up
//           to a factor, which is chosen so that their median is right.
// lookups   per estimator: display PSNR and mean lookups, adaptive, and the uniform lookups that reach the same PSNR.
// time      of shading against lookups a pixel, one thread.
#include "bench/rank_statistics.h"
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/frequency/light_bandwidth.h>
#include <burnish/frequency/lobe_bandwidth.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/material/lobe.h>
#include <burnish/output/compare.h>
#include <burnish/sampling/sample_ladder.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/dense.h>
#include <burnish/shading/table_shading.h>
#include <burnish/shading/tap_rule.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>

using namespace burnish;

namespace {

const std::map<std::string, EstimatorKind> kEstimators{{"regular", EstimatorKind::regular},
                                                       {"filtered_importance", EstimatorKind::filtered_importance},
                                                       {"preconvolved", EstimatorKind::preconvolved}};
const std::map<std::string, ModelId> kModels{{"kurt", ModelId::kurt}, {"beckmann", ModelId::beckmann}, {"ggx", ModelId::ggx}};
constexpr int kUniform[] = {4, 7, 12, 19, 30, 45, 64, 91}, kAdaptive[] = {12, 19, 38, 64};
constexpr uint32_t kBruteSamples = 2048, kDirections = 16;

struct Options {
    int size = 32, stress = 2, time_size = 512;
    std::vector<std::string> files, models{"beckmann", "ggx"}, estimators{"regular", "filtered_importance", "preconvolved"};
    std::vector<float> widths{0.03f, 0.1f, 0.3f};
    bool no_variance = false, no_lookups = false;
};

struct Light {
    std::string name;
    Environment environment;
};

/// Variances of one pixel's integrand, and what foretells them.
struct Variances {
    double importance = 0, uniform = 0, moments = 0, bandwidth = 0, preconvolved = 0;
};

class Bench {
public:
    explicit Bench(const Options& options)
        : m_options(options),
          m_frame(scenes::sphere_frame(options.size)),
          m_assignment(scenes::whole_frame(m_frame)),
          m_surfaces(m_frame, m_assignment, {}) {
        EnvironmentSettings settings;
        settings.face_size = 256;
        for (int i = 0; i < options.stress; ++i)
            m_lights.push_back({"stress-" + std::to_string(1 + i),
                                Environment::from_image(scenes::stress_light(1000 + i, 512), settings, "stress")});
        for (const std::string& file : options.files)
            m_lights.push_back({file.substr(file.rfind('/') + 1), Environment::load(file, settings)});
        m_surfaces.gather({0, 0, options.size, options.size}, 0, m_batch);
    }

    void variance() const {
        std::puts("table,light,model,m,prediction,rank_importance,rank_uniform,under_half_of_importance");
        for_all([&](const Light& light, const std::string& model, const LobeParameters& lobe) {
            const std::vector<Variances> pixels = variances(light.environment, lobe);
            const auto all = [&](double Variances::*member) {
                std::vector<double> values;
                for (const Variances& pixel : pixels) values.push_back(pixel.*member);
                return values;
            };
            const auto importance = all(&Variances::importance), uniform = all(&Variances::uniform);
            const auto row = [&](const char* name, double Variances::*member, bool scaled) {
                const auto predicted = all(member);
                std::printf("variance,%s,%s,%g,%s,%.3f,%.3f,%.3f\n", light.name.c_str(), model.c_str(), lobe.mx, name,
                            rank_correlation(predicted, importance), rank_correlation(predicted, uniform),
                            share_below_half(predicted, importance, scaled));
            };
            row("moments", &Variances::moments, false);
            row("bandwidth", &Variances::bandwidth, true);
            row("preconvolved", &Variances::preconvolved, true);
        });
    }

    void lookups() const {
        std::puts("table,estimator,light,model,m,most,adaptive_lookups,psnr_db,uniform_psnr_db,uniform_lookups,ratio");
        std::map<std::string, std::vector<Point>> uniform_mean, adaptive_mean;
        for_all([&](const Light& light, const std::string& model, const LobeParameters& lobe) {
            EstimatorSettings exact;
            exact.kind = EstimatorKind::reference, exact.tolerance = 0.005f;
            const ShadedFrame truth = shade(m_surfaces, m_assignment, light, lobe, exact);
            for (const std::string& estimator : m_options.estimators) {
                const std::string where = light.name + "," + model + "," + std::to_string(lobe.mx);
                const auto uniform = points(light, lobe, kEstimators.at(estimator), false, truth),
                           adaptive = points(light, lobe, kEstimators.at(estimator), true, truth);
                print(estimator, where, uniform, adaptive);
                add_share(uniform, uniform_mean[estimator]), add_share(adaptive, adaptive_mean[estimator]);
            }
            std::fflush(stdout);
        });
        for (const std::string& estimator : m_options.estimators)
            print(estimator, "all,all,all", uniform_mean[estimator], adaptive_mean[estimator]);
    }

    void time() const {
        const ThreadLimit one(1);
        const AovFrame frame = scenes::sphere_frame(m_options.time_size);
        const Assignment assignment = scenes::whole_frame(frame);
        const Surfaces surfaces(frame, assignment, {});
        const LobeParameters lobe = scenes::lobe_of(ModelId::ggx, 0.1f, 0.1f);
        std::puts("table,estimator,most,mode,lookups_per_pixel,ns_per_pixel");
        for (const std::string& estimator : m_options.estimators)
            for (const bool adaptive : {false, true})
                for (const int most : {8, 16, 32, 64, 128}) {
                    EstimatorSettings settings;
                    settings.kind = kEstimators.at(estimator), settings.samples = most, settings.adaptive = adaptive;
                    const std::vector<MaterialShader> shaders{
                        {{"bench", Color3f(0), {lobe}}, m_lights[0].environment, settings}};
                    double best = 1e30, lookups = 0;
                    for (int run = 0; run < 5; ++run) {
                        const auto begin = std::chrono::steady_clock::now();
                        lookups = shade_dense(surfaces, assignment, shaders, {}).lookups;
                        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
                    }
                    const double pixels = static_cast<double>(surfaces.counts()[static_cast<size_t>(Validity::valid)]);
                    std::printf("time,%s,%d,%s,%.2f,%.1f\n", estimator.c_str(), most, adaptive ? "adaptive" : "uniform",
                                lookups / pixels, 1e9 * best / pixels);
                }
    }

private:
    /// Mean lookups a pixel and mean squared display error.
    struct Point {
        int most = 0;
        double lookups = 0, error = 0;
    };

    template <class Work>
    void for_all(const Work& work) const {
        for (const Light& light : m_lights)
            for (const std::string& model : m_options.models)
                for (const float m : m_options.widths) work(light, model, scenes::lobe_of(kModels.at(model), m, m));
    }

    static ShadedFrame shade(const Surfaces& surfaces, const Assignment& assignment, const Light& light,
                             const LobeParameters& lobe, const EstimatorSettings& settings) {
        return shade_dense(surfaces, assignment, {MaterialShader({"bench", Color3f(0), {lobe}}, light.environment, settings)},
                           {}, true);
    }

    std::vector<Point> points(const Light& light, const LobeParameters& lobe, EstimatorKind kind, bool adaptive,
                              const ShadedFrame& truth) const {
        std::vector<Point> result;
        for (const int most : adaptive ? std::span<const int>(kAdaptive) : std::span<const int>(kUniform)) {
            EstimatorSettings settings;
            settings.kind = kind, settings.samples = most, settings.adaptive = adaptive;
            const ShadedFrame frame = shade(m_surfaces, m_assignment, light, lobe, settings);
            const Comparison found = compare_images(frame.overlay, truth.overlay, &truth.samples);
            result.push_back(
                {most, frame.lookups / static_cast<double>(found.pixels), std::pow(10, -found.display_psnr_db / 10)});
        }
        return result;
    }

    /// Towards the mean of all cases.
    void add_share(const std::vector<Point>& points, std::vector<Point>& mean) const {
        const double cases = static_cast<double>(m_lights.size() * m_options.models.size() * m_options.widths.size());
        mean.resize(points.size());
        for (size_t i = 0; i < points.size(); ++i) {
            mean[i].most = points[i].most;
            mean[i].lookups += points[i].lookups / cases, mean[i].error += points[i].error / cases;
        }
    }

    /// Uniform lookups with this error, between the counts tried; errors that do not fall with the count are left out.
    static double equal_lookups(const std::vector<Point>& uniform, double error) {
        Point last = uniform[0];
        for (const Point& point : uniform) {
            if (point.error >= last.error) continue;
            if (point.error <= error && last.error > error)
                return last.lookups * std::pow(point.lookups / last.lookups,
                                               std::log(last.error / error) / std::log(last.error / point.error));
            last = point;
        }
        return error >= uniform[0].error ? uniform[0].lookups : last.lookups;
    }

    static void print(const std::string& estimator, const std::string& where, const std::vector<Point>& uniform,
                      const std::vector<Point>& adaptive) {
        for (const Point& point : adaptive) {
            const auto same = std::ranges::find(uniform, point.most, &Point::most);
            const double equal = equal_lookups(uniform, point.error);
            std::printf("lookups,%s,%s,%d,%.2f,%.2f,%.2f,%.2f,%.2f\n", estimator.c_str(), where.c_str(), point.most,
                        point.lookups, -10 * std::log10(point.error),
                        same == uniform.end() ? 0.0 : -10 * std::log10(same->error), equal, equal / point.lookups);
        }
    }

    std::vector<Variances> variances(const Environment& light, const LobeParameters& lobe) const {
        EstimatorSettings few;
        few.kind = EstimatorKind::regular, few.samples = kFewestLookups;
        const TapRule rule(lobe, few, [&](float omega) { return light.pyramid().level(omega) + few.level_bias; });
        const TapTable table(lobe, rule.tap_count(lobe.mx, lobe.my), rule);
        std::vector<Color3f> overlay(m_batch.size(), Color3f(0));
        std::vector<float> samples(m_batch.size()), square(m_batch.size()), weight(m_batch.size());
        const auto& stack = light.pyramid().stack();
        add_table_shading({{lobe, table, light.world_to_light()}, stack, CubePyramid::kDistortion, light.gain()}, m_batch,
                          {overlay, samples, square, weight});
        const LightBandwidth nu_a(light);
        const LobeBandwidth nu_rho(lobe);
        std::vector<Variances> result(m_batch.size());
        for_each_index(static_cast<int>(m_batch.size()), [&](int i) {
            const ShadingPoint point = shading_point(m_batch, i, lobe, light.world_to_light());
            const float mean = luminance(overlay[i]);
            result[i] = brute_force(light, lobe, point);
            result[i].moments = relative_variance(mean, square[i], weight[i]) * mean * mean;
            add_bandwidth_sums(light, lobe, point, nu_a, nu_rho, result[i]);
        });
        return result;
    }

    /// The light without its suns, as the filtered estimators see it.
    static Variances brute_force(const Environment& light, const LobeParameters& parameters, const ShadingPoint& point) {
        return visit_lobe(parameters, [&](const auto& lobe) {
            double sum = 0, square = 0, uniform = 0;
            for (uint32_t i = 0; i < kBruteSamples; ++i) {
                const Vec3f wi = lobe.sample(point.wo, owen_sobol(i, 7));
                const double pdf = lobe.pdf(point.wo, wi);
                if (wi.z <= 0 || pdf <= 0) continue;
                const double f =
                    luminance(lobe.eval(point.wo, wi) * light.pyramid().lookup(point.frame.to_world(wi), 0)) * wi.z;
                sum += f / pdf, square += f * f / (pdf * pdf), uniform += f * f / pdf;
            }
            sum /= kBruteSamples, square /= kBruteSamples, uniform /= kBruteSamples;
            return Variances{std::max(square - sum * sum, 0.0), 2 * kPi * uniform - sum * sum};
        });
    }

    /// Sums over importance samples of the lobe, chi = L rho cos with L filtered over what each stands for.
    static void add_bandwidth_sums(const Environment& light, const LobeParameters& parameters, const ShadingPoint& point,
                                   const LightBandwidth& nu_a, const LobeBandwidth& nu_rho, Variances& out) {
        visit_lobe(parameters, [&](const auto& lobe) {
            for (uint32_t k = 0; k < kDirections; ++k) {
                const Vec3f wi = lobe.sample(point.wo, hammersley(k, kDirections)), d = point.frame.to_world(wi);
                const float pdf = lobe.pdf(point.wo, wi);
                if (wi.z <= 0 || pdf <= 0) continue;
                const float omega = 1 / (kDirections * pdf), nu = nu_rho.at(point.wo, wi);
                const Color3f L = light.pyramid().lookup(d, light.pyramid().level(d, omega));
                const double chi = luminance(lobe.eval(point.wo, wi) * L) * wi.z;
                out.bandwidth += (nu_a.at(d, std::min(std::sqrt(omega / kPi), kPi / 4)) + nu) * chi * chi * omega;
                out.preconvolved += 2 * nu * chi * chi * omega;
            }
        });
    }

    Options m_options;
    AovFrame m_frame;
    Assignment m_assignment;
    Surfaces m_surfaces;
    SurfaceBatch m_batch;
    std::vector<Light> m_lights;
};

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Adaptive sample counts: prediction of the variance, lookups saved, time per lookup");
    app.add_option("--size", options.size, "sphere diameter in pixels")->capture_default_str();
    app.add_option("--time-size", options.time_size, "the same for the timings; 0: none")->capture_default_str();
    app.add_option("--stress", options.stress, "number of stress lights")->capture_default_str();
    app.add_option("--lights-from", options.files, "environment files")->delimiter(',');
    app.add_option("--models", options.models, "kurt, beckmann, ggx")->delimiter(',')->capture_default_str();
    app.add_option("--m", options.widths, "slope widths")->delimiter(',')->capture_default_str();
    app.add_option("--estimators", options.estimators, "regular, filtered_importance, preconvolved")
        ->delimiter(',')
        ->capture_default_str();
    app.add_flag("--no-variance", options.no_variance, "without the first table");
    app.add_flag("--no-lookups", options.no_lookups, "without the second");
    CLI11_PARSE(app, argc, argv);
    const Bench bench(options);
    if (!options.no_variance) bench.variance();
    if (!options.no_lookups) bench.lookups();
    if (options.time_size > 0) bench.time();
    return 0;
}
