#include <burnish/light/environment.h>

#include <burnish/light/environment_source.h>
#include <burnish/light/latlong.h>

namespace burnish {

Color3f Environment::Source::radiance(const Vec3f& d) const {
    if (!is_cube()) return latlong_bilinear(latlong, latlong_coord(d));
    float rgba[4] = {0, 0, 0, 0};
    cube.add_bilinear(cube_coord(d), 1.0f, rgba);
    return {rgba[0], rgba[1], rgba[2]};
}

Color3f Environment::radiance(const Vec3f& d) const { return m_source->radiance(d); }

}  // namespace burnish
