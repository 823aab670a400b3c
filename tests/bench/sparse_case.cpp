#include "bench/sparse_case.h"

#include "bench/sparse_oracle.h"

#include <burnish/output/compare.h>
#include <burnish/output/preview.h>
#include <burnish/shading/shading_plan.h>
#include <burnish/shading/sparse.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace burnish {
namespace {

/// Processor time: on a busy machine the clock says little.
template <class Work>
double milliseconds(int repeats, Work&& work) {
    double least = 1e30;
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t begin = std::clock();
        work();
        least = std::min(least, 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return least;
}

Image valid_mask(const Surfaces& surfaces, const Assignment& assignment) {
    Image mask(assignment.width, assignment.height, 1);
    for (size_t i = 0; i < mask.pixel_count(); ++i) mask.data[i] = surfaces.validity(i) == Validity::valid;
    return mask;
}

std::vector<MaterialShader> shaders_of(const SparseCase& what, const Environment& light, const EstimatorSettings& settings) {
    std::vector<MaterialShader> shaders;
    for (const Material& material : what.materials) shaders.emplace_back(material, light, settings);
    return shaders;
}

void write_pictures(const std::string& prefix, const ShadedFrame& dense, const ShadedFrame& sparse, double mean) {
    PreviewSettings look;
    look.exposure_stops = static_cast<float>(std::log2(0.18 / mean));
    write_preview(prefix + "_dense.png", dense.overlay, look);
    write_preview(prefix + "_sparse.png", sparse.overlay, look);
    Image error(dense.overlay.width, dense.overlay.height, 3), shaded = error;
    const double scale = 0.18 / mean;
    for (size_t i = 0; i < error.data.size(); ++i) {
        const auto shown = [&](const Image& image) { return encoded(static_cast<double>(image.data[i]) * scale); };
        error.data[i] = static_cast<float>(8 * std::fabs(shown(sparse.overlay) - shown(dense.overlay)));
        shaded.data[i] = sparse.samples.data[i / 3] > 0 ? 1.0f : 0.0f;
    }
    write_preview(prefix + "_error.png", error, {});
    write_preview(prefix + "_shaded.png", shaded, {});
}

}  // namespace

SparseFigures measure_sparse(const SparseCase& what, const Environment& light, const SparseSettings& settings,
                             const std::string& pictures) {
    const AovFrame& frame = what.frame;
    const Assignment& assignment = what.assignment;
    const Surfaces surfaces(frame, assignment, what.surface);
    const std::vector<MaterialShader> shaders = shaders_of(what, light, settings.estimator);
    std::vector<BandwidthPredictor> predictors;
    for (const Material& material : what.materials) predictors.emplace_back(material, light, settings.density);

    SparseFigures figures;
    ShadedFrame dense, sparse;
    const auto least = [&](auto&& work) { return milliseconds(settings.repeats, work); };
    figures.dense_ms = least([&] { dense = shade_dense(surfaces, assignment, shaders, {}); });
    figures.sparse_ms = least([&] { sparse = shade_sparse(frame, surfaces, assignment, shaders, predictors, {}); });
    const PerPixel used = used_layers(predictors);
    figures.turning_ms = least([&] { CellTurning(frame, surfaces, assignment, used); });
    const CellTurning turning(frame, surfaces, assignment, used);
    figures.plan_ms = least([&] { ShadingPlan(turning, surfaces, assignment, predictors); });
    if (settings.with_regular) {
        EstimatorSettings regular;
        regular.kind = EstimatorKind::regular, regular.samples = 16;
        const std::vector<MaterialShader> others = shaders_of(what, light, regular);
        figures.regular_ms = least([&] { shade_dense(surfaces, assignment, others, {}); });
    }

    const Image mask = valid_mask(surfaces, assignment);
    const auto valid = static_cast<double>(surfaces.counts()[0]);
    const Comparison error = compare_images(sparse.overlay, dense.overlay, &mask);
    sparse = shade_sparse(frame, surfaces, assignment, shaders, predictors, {}, true);
    figures.shaded = static_cast<double>(std::ranges::count_if(sparse.samples.data, [](float n) { return n > 0; })) / valid;
    figures.oracle = static_cast<double>(oracle_pixels(dense.overlay, mask)) / valid;
    figures.psnr_db = error.display_psnr_db, figures.largest_error = error.largest_error;
    figures.worst_x = error.largest_x, figures.worst_y = error.largest_y;
    if (!pictures.empty()) write_pictures(pictures, dense, sparse, error.reference_mean);
    return figures;
}

}  // namespace burnish
