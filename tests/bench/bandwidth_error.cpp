// Predicted against measured bandwidth: windowed Fourier transforms of dense renders of a sphere, as CSV on standard output.
//
// One row per (light, radius, m, prediction). Levels are windowed_level; `under_%` of the windows are predicted more than one
// level too coarse, `over_%` more than one too fine; `gap` is the mean of predicted less measured level. Times are of all valid
// pixels in one batch, one thread, the least of three. --pictures DIR also draws each (light, radius, m).
#include "bench/bandwidth_pictures.h"
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/job/bandwidth_layers.h>
#include <burnish/shading/dense.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numeric>

using namespace burnish;

namespace {

struct Study {
    std::vector<int> radii{120, 400};
    std::vector<float> widths{0.01f, 0.03f, 0.1f, 0.3f};
    std::vector<std::string> lights, predictions{"source", "correlated", "curvature"};
    std::string model = "ggx", pictures;
    DensitySettings density{.safety = 1};
    bool display = false;
};

const std::map<std::string, ModelId> kModels{{"kurt", ModelId::kurt}, {"beckmann", ModelId::beckmann}, {"ggx", ModelId::ggx}};
const std::map<std::string, PredictionKind> kPredictions{
    {"source", PredictionKind::source}, {"correlated", PredictionKind::correlated}, {"curvature", PredictionKind::curvature}};

std::vector<double> ranks(const std::vector<float>& values) {
    std::vector<size_t> order(values.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::sort(order, {}, [&](size_t i) { return values[i]; });
    std::vector<double> rank(values.size());
    for (size_t i = 0; i < order.size();) {
        size_t end = i;
        while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
        for (size_t k = i; k < end; ++k) rank[order[k]] = 0.5 * static_cast<double>(i + end - 1);
        i = end;
    }
    return rank;
}

/// Spearman's: correlation of ranks, ties sharing theirs.
double rank_correlation(const std::vector<float>& a, const std::vector<float>& b) {
    const std::vector<double> x = ranks(a), y = ranks(b);
    const double mean = 0.5 * (static_cast<double>(x.size()) - 1);
    double xy = 0, xx = 0, yy = 0;
    for (size_t i = 0; i < x.size(); ++i)
        xy += (x[i] - mean) * (y[i] - mean), xx += (x[i] - mean) * (x[i] - mean), yy += (y[i] - mean) * (y[i] - mean);
    return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0.0;
}

Image mask_of(const Surfaces& surfaces, const Image& like) {
    Image mask(like.width, like.height, 1);
    for (size_t i = 0; i < mask.pixel_count(); ++i) mask.data[i] = surfaces.validity(i) == Validity::valid;
    return mask;
}

/// The least wall time of three runs, nanoseconds a pixel.
template <class Work>
double nanoseconds(const SurfaceBatch& batch, const Work& work) {
    double least = 1e30;
    for (int i = 0; i < 3; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        least = std::min(least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
    }
    return least / static_cast<double>(batch.size());
}

struct Case {
    const Study& study;
    std::string light_name;
    const Environment& light;
    int radius;
    float m;

    void run() const {
        const AovFrame frame = scenes::sphere_frame(2 * radius);
        const Assignment assignment = scenes::whole_frame(frame);
        const Surfaces surfaces(frame, assignment, {});
        const std::vector<Material> materials{{"bench", Color3f(0, 0, 0), {scenes::lobe_of(kModels.at(study.model), m, m)}}};
        const std::vector<MaterialShader> shaders{MaterialShader(materials[0], light, EstimatorSettings{})};
        const Image overlay = shade_dense(surfaces, assignment, shaders, {}).overlay;
        SurfaceBatch all;
        surfaces.gather({0, 0, overlay.width, overlay.height}, 0, all);
        ShadedBatch shaded;
        const double dense_ns = nanoseconds(all, [&] { shaders[0].shade(all, shaded); });

        const int stride = radius > 200 ? 16 : 8;
        const auto windows = window_bandwidths(luminance_picture(overlay, study.display), mask_of(surfaces, overlay), stride);
        BandwidthPictures pictures(overlay, windows, stride);
        for (const std::string& prediction : study.predictions) {
            DensitySettings settings = study.density;
            settings.prediction = kPredictions.at(prediction);
            const BandwidthLook look{{BandwidthPredictor(materials[0], light, settings)},
                                     prepare_variances(materials, light, settings)};
            const BandwidthLayers layers = bandwidth_layers(frame, assignment, surfaces, look, EstimatorKind::fitted, {});
            std::vector<AngularPrediction> angular(all.size());
            const double predict_ns = nanoseconds(all, [&] { look.predictors[0].predict(all, angular); });
            print_row(prediction, layers, windows, predict_ns, dense_ns);
            pictures.add(prediction, layers.bandwidth);
        }
        char name[96];
        std::snprintf(name, sizeof name, "/%s_r%d_m%g", light_name.c_str(), radius, m);
        if (!study.pictures.empty()) pictures.write(study.pictures + name);
    }

    void print_row(const std::string& prediction, const BandwidthLayers& layers, const std::vector<PictureWindow>& windows,
                   double predict_ns, double dense_ns) const {
        std::vector<float> predicted, measured;
        double under = 0, over = 0, gap = 0;
        for (const PictureWindow& w : windows) {
            predicted.push_back(window_mean(layers.bandwidth, w)), measured.push_back(w.bandwidth);
            const float difference = windowed_level(predicted.back()) - windowed_level(measured.back());
            under += difference > 1, over += difference < -1, gap += difference;
        }
        const auto count = static_cast<double>(windows.size());
        std::printf("%s,%d,%s,%g,%s,%zu,%.3f,%.2f,%.2f,%.2f,%.0f,%.0f\n", light_name.c_str(), radius, study.model.c_str(), m,
                    prediction.c_str(), windows.size(), rank_correlation(predicted, measured), 100 * under / count,
                    100 * over / count, gap / count, predict_ns, dense_ns);
        std::fflush(stdout);
    }
};

}  // namespace

int main(int argc, char** argv) {
    Study study;
    CLI::App app("Predicted against measured bandwidth");
    app.add_option("--radii", study.radii, "of the sphere, pixels")->delimiter(',')->capture_default_str();
    app.add_option("--m", study.widths, "slope widths")->delimiter(',')->capture_default_str();
    app.add_option("--model", study.model, "kurt, beckmann or ggx")->capture_default_str();
    app.add_option("--lights", study.lights, "environment maps; none: a stress light")->delimiter(',');
    app.add_option("--predictions", study.predictions, "source, correlated, curvature")->delimiter(',')->capture_default_str();
    app.add_option("--directions", study.density.directions, "per lobe; 0: by kind")->capture_default_str();
    app.add_option("--safety", study.density.safety)->capture_default_str();
    app.add_option("--pictures", study.pictures, "folder for PNGs and EXRs: render, measured and predicted levels");
    app.add_flag("--display", study.display, "measure the picture as a display shows it, not linear light");
    CLI11_PARSE(app, argc, argv);
    std::puts("light,radius,model,m,prediction,windows,rank_correlation,under_%,over_%,gap,predict_ns,dense_ns");
    const auto rows = [&](const std::string& name, const Environment& light) {
        for (const int radius : study.radii)
            for (const float m : study.widths) Case{study, name, light, radius, m}.run();
    };
    for (const std::string& file : study.lights) rows(std::filesystem::path(file).stem().string(), Environment::load(file, {}));
    if (study.lights.empty()) rows("stress", Environment::from_image(scenes::stress_light(1), {}, "stress"));
    return 0;
}
