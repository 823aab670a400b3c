// Measures what costs are predicted from: each constant on its own, on light and surfaces made here, the least of a few runs.
#include <burnish/plan/machine_costs.h>

#include <burnish/base/types.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/light.h>
#include <burnish/material/albedo.h>
#include <burnish/material/any_model.h>
#include <burnish/material/model.h>
#include <burnish/plan/cost_model.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/sparse.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

namespace burnish {
namespace {

constexpr int kFace = 128, kWidth = 512, kHeight = 256, kPixels = kWidth * kHeight;

template <class Work>
double seconds_of(Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Of some runs: as many as a quarter of a second holds, three at the least.
template <class Work>
double least_seconds(Work&& work) {
    constexpr double kEnough = 0.25;
    double least = 1e30, spent = 0;
    for (int run = 0; run < 3 || spent < kEnough; ++run) {
        const double seconds = seconds_of(work);
        least = std::min(least, seconds), spent += seconds;
    }
    return least;
}

/// Smooth waves, and where asked for a small disc bright enough to be taken for a sun.
Environment made_light(bool with_sun) {
    Image picture(4 * kFace, 2 * kFace, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float value = 1.5f + std::sin(0.05f * static_cast<float>(x)) * std::cos(0.07f * static_cast<float>(y));
            const bool is_sun = with_sun && x == 100 && y == 60;
            std::fill_n(picture.at(x, y), 3, is_sun ? 1e5f : value);
        }
    EnvironmentSettings settings;
    settings.face_size = kFace;
    return Environment::from_image(picture, settings, "calibration");
}

/// A waved sheet that covers the frame.
AovFrame made_frame() {
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, kWidth, kHeight};
    Image position(kWidth, kHeight, 3), normal(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float px = 2 * (x + 0.5f) / kWidth - 1, py = 0.5f - (y + 0.5f) / kHeight;
            const Vec3f p(px, py, 0), n = Vec3f(0.4f * std::cos(4 * px), 0.4f * std::sin(5 * py), 1).normalized();
            std::copy_n(&p.x, 3, position.at(x, y));
            std::copy_n(&n.x, 3, normal.at(x, y));
        }
    frame.layers[Role::position] = std::move(position), frame.layers[Role::normal] = std::move(normal);
    frame.camera = Camera{};
    frame.camera->centre = Vec3f(0, 0, 3);
    return frame;
}

Assignment everywhere() {
    Assignment assignment;
    assignment.width = kWidth, assignment.height = kHeight;
    assignment.rule.assign(kPixels, 0), assignment.coverage.assign(kPixels, 1.0f);
    assignment.counts = {kPixels};
    return assignment;
}

LobeParameters ggx(float mx, float my) {
    LobeParameters lobe;
    lobe.model = ModelId::ggx, lobe.mx = mx, lobe.my = my;
    return lobe;
}

Material wearing(const LobeParameters& lobe) { return {"calibration", Color3f(0, 0, 0), {lobe}}; }

/// Each constant from the time of one piece of work, less what the model says of the rest of it: constants enter linearly.
class Calibration {
public:
    MachineCosts costs;

    void filter_light() {
        double pyramid = 1e30, stack = 1e30;
        for (int run = 0; run < 5; ++run) {
            const Environment fresh = made_light(false);
            pyramid = std::min(pyramid, seconds_of([&] { fresh.pyramid(); }));
            stack = std::min(stack, seconds_of([&] { fresh.gaussian_stack().stack(); }));
        }
        constexpr double kTexels = 6.0 * kFace * kFace;
        costs.pyramid_texel = pyramid / kTexels, costs.stack_texel = stack / kTexels;
    }

    void evaluate_models() {
        constexpr int kSamples = 8192;
        for (size_t i = 0; i < models().size(); ++i) {
            LobeParameters lobe = ggx(0.1f, 0.1f);
            lobe.model = static_cast<ModelId>(i), lobe.extra = default_parameters(models()[i]);
            if (lobe.model == ModelId::table) continue;  // has no numbers without a measurement
            if (const float own = prepare(lobe); own > 0) lobe.mx = lobe.my = own;
            const double seconds = least_seconds([&] { directional_albedo(lobe, Vec3f(0.6f, 0, 0.8f), kSamples); });
            costs.evaluation[std::string(models()[i].name)] = seconds / kSamples;
        }
    }

    void make_tables() {
        using enum EstimatorKind;
        solve_table(&MachineCosts::table_lookup, kRound, {filtered_importance, 512});
        solve_table(&MachineCosts::fit_lookup, kRound, {fitted, 8});
        solve_table(&MachineCosts::turned_fit_lookup, kLong, {fitted, 4});
    }

    void shade_densely() {
        using enum EstimatorKind;
        const double few = dense_seconds(m_light, {regular, 7}), many = dense_seconds(m_light, {regular, 61});
        costs.lookup = std::max(0.0, many - few) / (54.0 * kPixels);
        solve(&MachineCosts::pixel, few, [&] { return shading_of({regular, 7}, m_case); });
        const double fits = dense_seconds(m_light, {fitted, 12});
        solve(&MachineCosts::stack_lookup, fits, [&] { return shading_of({fitted, 12}, m_case); });
        const Environment sunny = made_light(true);
        CostCase under_sun = m_case;
        under_sun.suns = static_cast<int>(sunny.discs().size());
        const double lit = dense_seconds(sunny, {regular, 7});
        solve(&MachineCosts::sun, lit, [&] { return shading_of({regular, 7}, under_sun); });
    }

    void shade_sparsely() {
        const Configuration how{EstimatorKind::regular, 19};
        DensitySettings density;
        density.safety = 1;
        const MaterialShader shader(wearing(kRound), m_light, with({}, how));
        const BandwidthPredictor predictor(wearing(kRound), m_light, density);
        ShadedFrame shaded;
        const double seconds =
            least_seconds([&] { shaded = shade_sparse(m_frame, m_surfaces, m_assignment, {shader}, {predictor}, {}, true); });
        const auto count = std::ranges::count_if(shaded.samples.data, [](float samples) { return samples > 0; });
        CostCase of = m_case;
        of.sparse_share = std::max(1e-6, static_cast<double>(count) / kPixels);
        solve(&MachineCosts::sparse_pixel, seconds, [&] { return shading_of(how, of, density.safety); });
    }

    void shade_exactly() {
        EstimatorSettings exact;
        exact.kind = EstimatorKind::reference, exact.tolerance = 1e-6f, exact.max_samples = 16;
        const MaterialShader shader(wearing(kRound), m_light, exact);
        double lookups = 1;
        const double seconds = least_seconds([&] { lookups = shade_dense(m_surfaces, m_assignment, {shader}, {}).lookups; });
        costs.reference_lookup = seconds / lookups;
    }

    void shade_by_maps() {
        const double made = least_seconds([&] { MaterialShader(wearing(kRound), m_light, with({}, kFactored)); });
        solve(&MachineCosts::maps, made, [&] { return predicted_cost(costs, wearing(kRound), kFactored, 0, m_case).tables; });
        const double seconds = dense_seconds(m_light, kFactored);
        solve(&MachineCosts::map_pixel, seconds, [&] { return shading_of(kFactored, m_case); });
    }

    void shade_near() {
        const Configuration how{EstimatorKind::regular, 7};
        const auto taps = std::make_shared<const MaterialTaps>(wearing(kRound), with({}, how));
        const BoundingPlanes box(OrientedBox{.half = Vec3f(5, 5, 5)}, Vec3f(0));
        const auto room = std::make_shared<const Light>(CubeMapLight(m_light, std::nullopt, Vec3f(0), box));
        const MaterialShader shader(taps, LightChain({{room, true}}));
        const double seconds = least_seconds([&] { shade_dense(m_surfaces, m_assignment, {shader}, {}); });
        CostCase near = m_case;
        near.is_near = true;
        solve(&MachineCosts::near_ray, seconds, [&] { return shading_of(how, near); });
    }

private:
    static inline const LobeParameters kRound = ggx(0.1f, 0.1f), kLong = ggx(0.2f, 0.07f);

    /// The constant that makes `predicted` equal to `measured`; 0 where the rest alone is more.
    template <class Predicted>
    void solve(double MachineCosts::*constant, double measured, Predicted&& predicted) {
        costs.*constant = 0;
        const double rest = predicted();
        costs.*constant = 1;
        costs.*constant = std::max(0.0, (measured - rest) / (predicted() - rest));
    }

    void solve_table(double MachineCosts::*constant, const LobeParameters& lobe, const Configuration& configuration) {
        const double measured = least_seconds([&] { MaterialShader(wearing(lobe), m_light, with({}, configuration)); });
        solve(constant, measured, [&] { return predicted_cost(costs, wearing(lobe), configuration, 0, m_case).tables; });
    }

    double shading_of(const Configuration& configuration, const CostCase& of, float safety = 0) const {
        return predicted_cost(costs, wearing(kRound), configuration, safety, of).shading;
    }

    double dense_seconds(const Environment& light, const Configuration& configuration) const {
        const MaterialShader shader(wearing(kRound), light, with({}, configuration));
        return least_seconds([&] { shade_dense(m_surfaces, m_assignment, {shader}, {}); });
    }

    Environment m_light = made_light(false);
    AovFrame m_frame = made_frame();
    Assignment m_assignment = everywhere();
    Surfaces m_surfaces{m_frame, m_assignment, {}};
    CostCase m_case{.pixels = kPixels, .frame_pixels = kPixels};
};

/// As the system calls its processor.
std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown processor";
}

}  // namespace

MachineCosts measure_costs(const Progress& progress) {
    Calibration calibration;
    calibration.costs.machine = processor_name();
    calibration.costs.cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    using Step = void (Calibration::*)();
    const std::pair<const char*, Step> steps[] = {{"light", &Calibration::filter_light},
                                                  {"models", &Calibration::evaluate_models},
                                                  {"tables", &Calibration::make_tables},
                                                  {"dense shading", &Calibration::shade_densely},
                                                  {"sparse shading", &Calibration::shade_sparsely},
                                                  {"maps", &Calibration::shade_by_maps},
                                                  {"reference", &Calibration::shade_exactly},
                                                  {"near lights", &Calibration::shade_near}};
    for (size_t i = 0; i < std::size(steps); ++i) {
        progress.report(steps[i].first, static_cast<float>(i) / std::size(steps));
        (calibration.*steps[i].second)();
    }
    progress.report("calibrated", 1);
    return calibration.costs;
}

}  // namespace burnish
