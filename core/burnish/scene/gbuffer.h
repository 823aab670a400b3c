// What a camera sees of a scene, as the AOVs a renderer would write: one ray through each pixel's centre, nothing filtered.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/frame.h>
#include <burnish/scene/trace.h>
#include <burnish/scene/view.h>

namespace burnish {

/// Planar depth of pixels that see nothing, as Cycles writes it.
inline constexpr float kMissDepth = 1e10f;

/// Raster positions are in pixels, x right, y down, pixel centres at + 0.5; screen points are Camera's, [-1, 1]^2, y up.
inline Vec2f screen_point(const Vec2f& raster, int width, int height) {
    return {2 * raster.x / static_cast<float>(width) - 1, 1 - 2 * raster.y / static_cast<float>(height)};
}
inline Vec2f pixel_centre(int x, int y) { return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}; }
/// Centre of cell `index` of the n x n cells of a pixel.
inline Vec2f subpixel(int x, int y, int index, int n) {
    const auto cell = [n](int i) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(n); };
    return {static_cast<float>(x) + cell(index % n), static_cast<float>(y) + cell(index / n)};
}

/// What the camera sees at a raster position; the hit's distance is its planar depth.
inline std::optional<Hit> closest_at(const Tracer& tracer, const Camera& camera, const Vec2f& raster, int width, int height) {
    return tracer.closest(camera.centre, camera.ray(screen_point(raster, width, height)));
}

/// Position, normal, geometric normal, planar depth, tangent, uv, roughness, object and material index. Where nothing is hit
/// all are 0, but depth is kMissDepth. Same bits for any thread count.
AovFrame trace_gbuffer(const Tracer& tracer, const View& view, const Progress& progress);
AovFrame trace_gbuffer(const Tracer& tracer, const Camera& camera, int width, int height, const Progress& progress);

}  // namespace burnish
