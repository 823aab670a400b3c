#include <burnish/shading/dense.h>

#include <burnish/base/parallel.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

void scatter(const SurfaceBatch& batch, const std::vector<float>& values, Image& image) {
    if (image.empty() || values.empty()) return;
    for (size_t i = 0; i < batch.size(); ++i) image.data[batch.pixel[i]] = values[i];
}

void scatter(const SurfaceBatch& batch, const ShadedBatch& shaded, ShadedFrame& frame) {
    for (size_t i = 0; i < batch.size(); ++i) {
        float* overlay = frame.overlay.at(static_cast<size_t>(batch.pixel[i]));
        const Color3f& c = shaded.overlay[i];
        overlay[0] = c.x, overlay[1] = c.y, overlay[2] = c.z;
    }
    scatter(batch, shaded.samples, frame.samples);
    scatter(batch, shaded.standard_error, frame.standard_error);
}

/// Just before its pixels are shaded: the tile then is in the cache.
void clear(const Window& tile, Image& image) {
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        std::fill_n(image.at(tile.x, y), static_cast<size_t>(tile.width) * image.channels, 0.0f);
}

/// Of one thread, kept from tile to tile: its planes grow once.
struct Scratch {
    SurfaceBatch batch;
    ShadedBatch shaded;
    double lookups = 0;  // whole numbers: their sum does not depend on its order
};

}  // namespace

ShadedFrame shade_dense(const Surfaces& surfaces, const Assignment& assignment, const std::vector<MaterialShader>& shaders,
                        const Progress& progress, bool with_samples) {
    const int width = assignment.width, height = assignment.height;
    const bool with_error = std::any_of(shaders.begin(), shaders.end(), [](const auto& s) { return s.estimates_error(); });
    const auto plane = [&](bool wanted) { return wanted ? Image(width, height, 1) : Image(); };
    ShadedFrame frame{Image::unset(width, height, 3), plane(with_error), plane(with_samples), 0};
    tbb::enumerable_thread_specific<Scratch> scratch;
    for_each_tile(width, height, progress, "shading", [&](const Window& tile) {
        auto& [batch, shaded, lookups] = scratch.local();
        clear(tile, frame.overlay);
        for (size_t rule = 0; rule < shaders.size(); ++rule) {
            if (surfaces.rule_counts()[rule] == 0) continue;
            surfaces.gather(tile, static_cast<int>(rule), batch, shaders[rule].needs());
            if (batch.size() == 0) continue;
            shaders[rule].shade(batch, shaded);
            lookups += std::reduce(shaded.samples.begin(), shaded.samples.end(), 0.0);
            scatter(batch, shaded, frame);
        }
    });
    for (const Scratch& thread : scratch) frame.lookups += thread.lookups;
    return frame;
}

}  // namespace burnish
