#include <burnish/shading/tile_shading.h>

#include <burnish/base/parallel.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>

namespace burnish {
namespace {

/// Returns the lookups of the batch.
double scatter(const SurfaceBatch& batch, const ShadedBatch& shaded, ShadedFrame& frame) {
    double lookups = 0;
    for (size_t i = 0; i < batch.size(); ++i) {
        float* overlay = frame.overlay.at(static_cast<size_t>(batch.pixel[i]));
        const Color3f& c = shaded.overlay[i];
        overlay[0] = c.x, overlay[1] = c.y, overlay[2] = c.z;
        *frame.samples.at(static_cast<size_t>(batch.pixel[i])) = shaded.samples[i];
        lookups += shaded.samples[i];
        if (!shaded.standard_error.empty())
            *frame.standard_error.at(static_cast<size_t>(batch.pixel[i])) = shaded.standard_error[i];
    }
    return lookups;
}

/// Of one thread, kept from tile to tile: its planes grow once.
struct Scratch {
    SurfaceBatch batch;
    ShadedBatch shaded;
    double lookups = 0;  // whole numbers: their sum does not depend on its order
};

}  // namespace

ShadedFrame shaded_frame(int width, int height, const std::vector<MaterialShader>& shaders) {
    const bool with_error = std::any_of(shaders.begin(), shaders.end(), [](const auto& s) { return s.estimates_error(); });
    return {Image(width, height, 3), with_error ? Image(width, height, 1) : Image(), Image(width, height, 1), 0};
}

void shade_tiles(const std::vector<MaterialShader>& shaders,
                 const std::function<void(const Window& tile, int rule, SurfaceBatch& batch)>& gather, const Progress& progress,
                 ShadedFrame& frame) {
    tbb::enumerable_thread_specific<Scratch> scratch;
    for_each_tile(frame.overlay.width, frame.overlay.height, progress, "shading", [&](const Window& tile) {
        auto& [batch, shaded, lookups] = scratch.local();
        for (size_t rule = 0; rule < shaders.size(); ++rule) {
            gather(tile, static_cast<int>(rule), batch);
            if (batch.size() == 0) continue;
            shaders[rule].shade(batch, shaded);
            lookups += scatter(batch, shaded, frame);
        }
    });
    for (const Scratch& thread : scratch) frame.lookups += thread.lookups;
}

}  // namespace burnish
