#include <burnish/shading/tile_shading.h>

#include <burnish/base/parallel.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <numeric>
#include <span>

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

constexpr size_t kBatch = 1024;  // pixels: what a batch holds stays in the second-level cache

/// Of one thread, kept from tile to tile: its planes grow once.
struct Scratch {
    PixelLists pixels;
    SurfaceBatch batch;
    ShadedBatch shaded;
    double lookups = 0;  // whole numbers: their sum does not depend on its order

    void shade(const Surfaces& surfaces, const MaterialShader& shader, std::span<const uint32_t> list, ShadedFrame& frame) {
        for (; !list.empty(); list = list.subspan(std::min(list.size(), kBatch))) {
            const auto part = list.first(std::min(list.size(), kBatch));
            batch.clear();
            batch.pixel.assign(part.begin(), part.end());
            surfaces.fill(batch, shader.needs());
            shader.shade(batch, shaded);
            lookups += std::reduce(shaded.samples.begin(), shaded.samples.end(), 0.0);
            scatter(batch, shaded, frame);
        }
    }
};

}  // namespace

ShadedFrame shaded_frame(int width, int height, const std::vector<MaterialShader>& shaders, bool with_samples) {
    const bool with_error = std::any_of(shaders.begin(), shaders.end(), [](const auto& s) { return s.estimates_error(); });
    const auto plane = [&](bool wanted) { return wanted ? Image(width, height, 1) : Image(); };
    return {Image::unset(width, height, 3), plane(with_error), plane(with_samples), 0};
}

void shade_tiles(const Surfaces& surfaces, const std::vector<MaterialShader>& shaders, int tile_size,
                 const std::function<void(const Window& tile, PixelLists& pixels)>& list, const Progress& progress,
                 ShadedFrame& frame) {
    tbb::enumerable_thread_specific<Scratch> scratch;
    const auto work = [&](const Window& tile) {
        Scratch& own = scratch.local();
        own.pixels.resize(shaders.size());
        for (std::vector<uint32_t>& pixels : own.pixels) pixels.clear();
        clear(tile, frame.overlay);
        list(tile, own.pixels);
        for (size_t rule = 0; rule < shaders.size(); ++rule) own.shade(surfaces, shaders[rule], own.pixels[rule], frame);
    };
    for_each_tile(frame.overlay.width, frame.overlay.height, progress, "shading", work, tile_size);
    for (const Scratch& thread : scratch) frame.lookups += thread.lookups;
}

}  // namespace burnish
