#include <burnish/shading/dense.h>

#include <burnish/base/parallel.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>

namespace burnish {
namespace {

void scatter(const SurfaceBatch& batch, const ShadedBatch& shaded, ShadedFrame& frame) {
    for (size_t i = 0; i < batch.size(); ++i) {
        float* overlay = frame.overlay.at(static_cast<size_t>(batch.pixel[i]));
        const Color3f& c = shaded.overlay[i];
        overlay[0] = c.x, overlay[1] = c.y, overlay[2] = c.z;
        *frame.samples.at(static_cast<size_t>(batch.pixel[i])) = shaded.samples[i];
        if (!shaded.standard_error.empty())
            *frame.standard_error.at(static_cast<size_t>(batch.pixel[i])) = shaded.standard_error[i];
    }
}

/// Of one thread, kept from tile to tile: its planes grow once.
struct Scratch {
    SurfaceBatch batch;
    ShadedBatch shaded;
};

}  // namespace

ShadedFrame shade_dense(const Surfaces& surfaces, const Assignment& assignment, const std::vector<MaterialShader>& shaders,
                        const Progress& progress) {
    const int width = assignment.width, height = assignment.height;
    const bool with_error = std::any_of(shaders.begin(), shaders.end(), [](const auto& s) { return s.estimates_error(); });
    ShadedFrame frame{Image(width, height, 3), with_error ? Image(width, height, 1) : Image(), Image(width, height, 1), 0};
    tbb::enumerable_thread_specific<Scratch> scratch;
    for_each_tile(width, height, progress, "shading", [&](const Window& tile) {
        auto& [batch, shaded] = scratch.local();
        for (size_t rule = 0; rule < shaders.size(); ++rule) {
            surfaces.gather(tile, static_cast<int>(rule), batch);
            if (batch.size() == 0) continue;
            shaders[rule].shade(batch, shaded);
            scatter(batch, shaded, frame);
        }
    });
    for (const float samples : frame.samples.data) frame.lookups += samples;
    return frame;
}

}  // namespace burnish
