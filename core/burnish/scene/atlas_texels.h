// Which point of a scene each texel of a light map is, and what texels near them are filled with.
#pragma once

#include <burnish/base/image.h>
#include <burnish/scene/scene.h>

#include <vector>

namespace burnish {

/// A texel's surface point; object < 0: none.
struct AtlasTexel {
    int object = -1;
    Vec3f p, n, ng;   // world space; unit, on the front
    float aside = 1;  // texels from the texel's middle to the point in the map, [0, 1)
};

/// The texels of a square map over the scene's texture coordinates. Those whose middle lies less than a texel beside a triangle
/// have its nearest point, so that bilinear lookups near edges find surface.
std::vector<AtlasTexel> atlas_texels(const Scene& scene, int size);

/// Gives texels without a point the mean of their neighbours that have one, `rings` times over.
void fill_gaps(Image& map, const std::vector<AtlasTexel>& texels, int rings);

}  // namespace burnish
