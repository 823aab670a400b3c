// Tangents where the renderer wrote none: dP/du from the differences of P and UV between neighbouring pixels.
#pragma once

#include <burnish/input/frame.h>

#include <optional>

namespace burnish {

/// Direction of growing u on the surface at `pixel` (world space, not unit), from one-sided differences that stay on the
/// same surface: same ids where there are any, position and UV close. Nothing where no neighbour qualifies or UVs do not vary.
///
///     dP/du  ~  (dv/dy dP/dx - dv/dx dP/dy) sign(du/dx dv/dy - du/dy dv/dx)
std::optional<Vec3f> uv_tangent(const AovFrame& frame, size_t pixel);

}  // namespace burnish
