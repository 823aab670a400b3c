// Depth layers: from depth to position, and telling planar depth from the distance along the ray.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/camera.h>
#include <burnish/input/row_strips.h>

namespace burnish {

/// World position (3 channels) of every pixel from its depth (first channel, holding `rows`).
///
///     planar:        P = centre + Z (axis + sx right + sy up)
///     ray distance:  P = centre + d normalised(axis + sx right + sy up)
///
/// NaN where nothing was hit: depth not finite, not positive, or 1e9 and more. Throws Error(bad_argument) for a camera
/// without rays.
Image position_from_depth(const Image& depth, const Camera& camera, const RowStrips& rows, const Window& display,
                          bool ray_distance);

/// What a depth layer measures, found from a position layer of the same frame.
enum class DepthKind {
    planar,        // along the viewing direction (Cycles, Arnold)
    ray_distance,  // from the centre (panoramas, Mitsuba, Octane)
    neither,       // scaled, clamped or encoded: not usable as a distance
};
DepthKind depth_kind(const Image& depth, const Image& position, const Camera& camera, const RowStrips& rows,
                     const Window& display);

/// True when the depth layer fits the distance from the centre better than the distance along the viewing direction.
inline bool depth_is_ray_distance(const Image& depth, const Image& position, const Camera& camera, const RowStrips& rows,
                                  const Window& display) {
    return depth_kind(depth, position, camera, rows, display) == DepthKind::ray_distance;
}

}  // namespace burnish
