#include <burnish/job/bandwidth_layers.h>

#include <burnish/base/parallel.h>
#include <burnish/frequency/bandwidth_buffer.h>
#include <burnish/frequency/operators.h>
#include <burnish/output/level_colors.h>
#include <burnish/surface/screen_curvature.h>

#include <algorithm>

namespace burnish {
namespace {

/// A prediction says what share of a period one cell may span; two cells a period are Nyquist's.
constexpr float kNyquist = 0.5f / kCellPeriods;
constexpr int kVarianceDirections = 16;  // the source's n_b
constexpr int kScaleHeight = 12;         // pixels
constexpr float kUnknown = -1;           // variance

struct Pixels {
    const ScreenCurvature& curvature;
    const EstimatorKind estimator;
    BandwidthLayers& layers;

    void set(const SurfaceBatch& batch, size_t i, const AngularPrediction& angular, const PathBandwidth& path) const {
        const size_t pixel = batch.pixel[i];
        const float c = curvature.at(pixel), d = (curvature.eye() - batch.p[i]).length();
        const float turn = curvature.pixel_angle() * reflection_turn(c, batch.n[i].dot(batch.wo[i]), d);
        const float shear = angular.nearness * curvature.pixel_angle() * d;
        const float nu_a = angular.nu_a * kNyquist, b = nu_a * (turn + shear);
        *layers.curvature.at(pixel) = c;
        *layers.nu_a.at(pixel) = nu_a, *layers.bandwidth.at(pixel) = b;
        *layers.level.at(pixel) = shading_level(b, layers.level.width, layers.level.height);
        *layers.samples.at(pixel) = estimator == EstimatorKind::reference ? path.variance : path.preconvolved_variance;
        *layers.shaded.at(pixel) = 1;
    }
};

/// `count`: of shaded pixels.
void scale_to_mean_one(Image& samples, size_t count) {
    double sum = 0;
    for (const float value : samples.data) {
        if (value == kUnknown)
            --count;
        else
            sum += value;
    }
    const float scale = sum > 0 ? static_cast<float>(static_cast<double>(count) / sum) : 1.0f;
    for (float& value : samples.data) value = value == kUnknown ? 1.0f : value * scale;
}

}  // namespace

Variances prepare_variances(const std::vector<Material>& materials, const Environment& light, const DensitySettings& settings) {
    Variances variances;
    DensitySettings of_variance = settings;
    if (settings.directions == 0) of_variance.directions = kVarianceDirections;
    const auto nu_light = std::make_shared<const LightBandwidth>(light);
    for (const Material& material : materials)
        variances.push_back(std::make_shared<const WaveletPrediction>(material, light, of_variance, nu_light));
    return variances;
}

BandwidthLayers bandwidth_layers(const AovFrame& frame, const Assignment& assignment, const Surfaces& surfaces,
                                 const BandwidthLook& look, EstimatorKind estimator, const Progress& progress) {
    const int width = assignment.width, height = assignment.height;
    const Image none(width, height, 1);
    BandwidthLayers layers{none, Image(width, height, 1, shading_level(0, width, height)), none, none, none, none};
    const ScreenCurvature curvature(frame, assignment, surfaces);
    const Pixels pixels{curvature, estimator, layers};
    PathBandwidth unknown;
    unknown.variance = unknown.preconvolved_variance = kUnknown;
    for_each_tile(width, height, progress, "predicting", [&](const Window& tile) {
        SurfaceBatch batch;
        std::vector<AngularPrediction> angular;
        std::vector<PathBandwidth> paths;
        for (size_t own = 0; own < look.predictors.size(); ++own) {
            surfaces.gather(tile, static_cast<int>(own), batch);
            if (batch.size() == 0) continue;
            angular.assign(batch.size(), {}), paths.assign(batch.size(), look.variances[own] ? PathBandwidth() : unknown);
            look.predictors[own].predict(batch, angular);
            if (look.variances[own]) look.variances[own]->predict(batch, std::span(paths));
            for (size_t i = 0; i < batch.size(); ++i) pixels.set(batch, i, angular[i], paths[i]);
        }
    });
    scale_to_mean_one(layers.samples, surfaces.counts()[static_cast<size_t>(Validity::valid)]);
    return layers;
}

void write_bandwidth(const std::string& file, const AovFrame& frame, const BandwidthLayers& layers, PixelType type,
                     const HeaderTexts& attributes) {
    const std::vector<Image> bandwidth = max_pyramid(layers.bandwidth), level = min_pyramid(layers.level),
                             samples = max_pyramid(layers.samples), curvature = max_pyramid(layers.curvature),
                             nu_a = max_pyramid(layers.nu_a);
    std::vector<OutputPart> parts;
    for (size_t k = 0; k < level.size(); ++k)
        parts.push_back({"level_" + std::to_string(k),
                         {{{"bandwidth.X"}, &bandwidth[k]},
                          {{"level.X"}, &level[k]},
                          {{"samples.X"}, &samples[k]},
                          {{"curvature.X"}, &curvature[k]},
                          {{"nu_a.X"}, &nu_a[k]}}});
    write_exr_parts(file, frame, parts, type, attributes);
}

Image level_picture(const BandwidthLayers& layers) {
    const int width = layers.level.width, height = layers.level.height;
    Image picture(width, height + kScaleHeight, 3);
    for (size_t i = 0; i < layers.level.pixel_count(); ++i) {
        const Color3f& color = level_color(*layers.level.at(i));
        if (*layers.shaded.at(i) > 0) std::copy_n(&color.x, 3, picture.at(i));
    }
    const auto count = static_cast<int>(kLevelColors.size());
    for (int y = height; y < height + kScaleHeight; ++y)
        for (int x = 0; x < width; ++x) std::copy_n(&level_color(static_cast<float>(x * count / width)).x, 3, picture.at(x, y));
    return picture;
}

}  // namespace burnish
