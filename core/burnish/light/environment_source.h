// Behind an Environment: the picture of light as given, lat-long or cube, with its sampling table, which the unfiltered
// lookups read, and the cube faces that the filtered ones are made from.
#pragma once

#include <burnish/light/environment_picture.h>
#include <burnish/light/filter/cube_level.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/sample_table.h>

#include <mutex>

namespace burnish {

/// Either the lat-long or the cube is set. Radiance is finite and >= 0.
class Environment::Source {
public:
    /// Either may be empty. The faces are kept, and made ready for lookups when these first ask, by any thread: few renders do.
    Source(Image latlong, std::shared_ptr<const std::array<Image, 6>> faces)
        : m_latlong(std::move(latlong)), m_faces(std::move(faces)) {}

    Color3f radiance(const Vec3f& d) const;
    Vec3f sample(const Vec2f& u, float& pdf) const;
    float pdf(const Vec3f& d) const;

private:
    bool is_cube() const { return m_faces != nullptr; }
    const CubeLevel& cube() const;
    /// Cells are the picture's texels (cube: six faces one below the other); weight = luminance of the bilinear picture
    /// integrated over the texel's solid angle. A cell is 0 only where the bilinear radiance is 0 in all of it.
    const SampleTable& table() const;

    Image m_latlong;
    std::shared_ptr<const std::array<Image, 6>> m_faces;
    mutable std::once_flag m_cube_made, m_table_made;
    mutable CubeLevel m_cube;
    mutable SampleTable m_table;
};

struct Environment::Filtered {
    Filtered(std::shared_ptr<const std::array<Image, 6>> cube_faces, PyramidKernel pyramid_kernel)
        : faces(std::move(cube_faces)), kernel(pyramid_kernel) {}

    const std::shared_ptr<const std::array<Image, 6>> faces;
    const PyramidKernel kernel;
    std::once_flag pyramid_made, stack_made;
    CubePyramid pyramid;
    GaussianStack stack;
};

}  // namespace burnish
