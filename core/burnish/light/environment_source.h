// Behind an Environment: the picture of light as given, lat-long or cube, with its sampling table, which the unfiltered
// lookups read, and the cube faces that the filtered ones are made from.
#pragma once

#include <burnish/light/cube_level.h>
#include <burnish/light/environment.h>
#include <burnish/light/gaussian_stack.h>
#include <burnish/light/sample_table.h>

#include <mutex>

namespace burnish {

/// Either `latlong` or `cube` is set. Radiance is finite and >= 0.
struct Environment::Source {
    Image latlong;
    CubeLevel cube;
    /// Cells are the picture's texels (cube: six faces one below the other); weight = luminance of the bilinear picture
    /// integrated over the texel's solid angle. A cell is 0 only where the bilinear radiance is 0 in all of it.
    SampleTable table;

    bool is_cube() const { return cube.size() > 0; }
    Color3f radiance(const Vec3f& d) const;
    void make_table();

    Vec3f sample(const Vec2f& u, float& pdf) const;
    float pdf(const Vec3f& d) const;
};

struct Environment::Filtered {
    Filtered(std::array<Image, 6> cube_faces, PyramidKernel pyramid_kernel)
        : faces(std::move(cube_faces)), kernel(pyramid_kernel) {}

    const std::array<Image, 6> faces;
    const PyramidKernel kernel;
    std::once_flag pyramid_made, stack_made;
    CubePyramid pyramid;
    GaussianStack stack;
};

}  // namespace burnish
