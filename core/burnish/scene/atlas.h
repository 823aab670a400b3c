// Texture coordinates under which every point of a scene has its own place: what a light map is painted on.
//
// Triangles that touch and face about the same way form a chart, seen along their first triangle's normal; charts are rectangles
// that stand on shelves, the tallest first, all at the same number of texels per scene unit.
#pragma once

#include <burnish/scene/scene.h>

namespace burnish {

/// Texels on every side of a chart that belong to no other.
inline constexpr int kAtlasMargin = 2;

/// Replaces all texture coordinates; vertices that several charts use are doubled, triangles
/// without area left out. `size`: texels along an edge of the square
/// map. Returns the texels per scene unit. Throws Error(bad_argument) when the charts are too many for the map.
float lay_out_atlas(Scene& scene, int size);

}  // namespace burnish
