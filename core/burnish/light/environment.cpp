#include <burnish/light/environment.h>

#include <burnish/light/environment_source.h>
#include <burnish/light/latlong.h>

namespace burnish {

const CubeLevel& Environment::Source::cube() const {
    std::call_once(m_cube_made, [this] { m_cube = CubeLevel(*m_faces); });
    return m_cube;
}

Color3f Environment::Source::radiance(const Vec3f& d) const {
    if (!is_cube()) return latlong_bilinear(m_latlong, latlong_coord(d));
    float rgba[4] = {0, 0, 0, 0};
    cube().add_bilinear(cube_coord(d), 1.0f, rgba);
    return {rgba[0], rgba[1], rgba[2]};
}

Color3f Environment::radiance(const Vec3f& d) const { return m_source->radiance(d); }

const CubePyramid& Environment::pyramid() const {
    Filtered& filtered = *m_filtered;
    std::call_once(filtered.pyramid_made, [&] { filtered.pyramid = CubePyramid(*filtered.faces, filtered.kernel); });
    return filtered.pyramid;
}

const GaussianStack& Environment::gaussian_stack() const {
    Filtered& filtered = *m_filtered;
    std::call_once(filtered.stack_made, [&] { filtered.stack = GaussianStack(filtered.faces); });
    return filtered.stack;
}

const std::array<Image, 6>& Environment::faces() const { return *m_filtered->faces; }

int Environment::face_size() const { return faces()[0].width; }

}  // namespace burnish
