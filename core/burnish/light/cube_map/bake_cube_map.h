// What a scene looks like from one point: the cube map that stands for the room around an object, with distances.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/light/environment.h>
#include <burnish/scene/surface_light.h>

#include <vector>

namespace burnish {

struct CubeMapView {
    Vec3f centre{0, 0, 0};
    int face_size = 256;
    int samples = 4;               // rays a texel
    UpAxis up = UpAxis::z;         // of the scene's world
    std::vector<int> hidden = {};  // indices into Scene::objects: what the map is made for
};

/// Six faces one below the other, as environment_layouts.h and OpenEXR's convention have them.
struct CubeMapPicture {
    Vec3f centre{0, 0, 0};
    Image rgba;      // radiance premultiplied by cover, cover: the share of the texel that sees a surface
    Image distance;  // to what the texel's middle sees, scene units; kMissDepth where that is nothing
};

/// Same bits for any thread count. Throws Error(cancelled).
CubeMapPicture bake_cube_map(const Tracer& tracer, const SurfaceLight& light, const CubeMapView& view,
                             const Progress& progress);

}  // namespace burnish
