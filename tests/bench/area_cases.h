// Lamps over a floor and a sphere: what estimators under area lights are compared on.
#pragma once

#include <burnish/light/area/area_light.h>
#include <burnish/surface/surface_batch.h>

#include <string>
#include <vector>

namespace burnish::area_cases {

struct Lamp {
    std::string name;
    AreaSettings settings;
    Image picture;  // empty: solid
};

/// Rectangles far, near, small and long; `textured` with a picture of tiles, a gradient and bulbs.
std::vector<Lamp> lamps(bool textured);

/// A floor seen at a slant under the lamps' reflections, or a sphere on it; about columns x rows pixels.
SurfaceBatch floor_view(int columns, int rows);
SurfaceBatch sphere_view(int columns, int rows);

}  // namespace burnish::area_cases
