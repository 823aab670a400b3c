#include <burnish/light/filter/cube_faces.h>

#include <cstdlib>

namespace burnish {

Vec3f cube_direction(int face, float x, float y) {
    const CubeFaceAxes& axes = kCubeFaces[face];
    Vec3f d;
    d[face / 2] = face % 2 ? -1.0f : 1.0f;
    d[axes.right] = axes.right_sign * (2.0f * x - 1.0f);
    d[axes.up] = axes.up_sign * (1.0f - 2.0f * y);
    return d / std::sqrt(d.length2());
}

// Works in whole numbers on the cube [-size, size]^3, where texel centres are odd or even integers: what reaches beyond an
// edge is bent round it, that is, it walks backwards along the forward axis.
CubeTexel unfolded_texel(int face, int x, int y, int size) {
    int right = 2 * x + 1 - size, up = size - 1 - 2 * y;
    const int excess = std::max({0, std::abs(right) - size, std::abs(up) - size});
    right = std::clamp(right, -size, size);
    up = std::clamp(up, -size, size);

    int p[3];
    const CubeFaceAxes& from = kCubeFaces[face];
    p[face / 2] = (face % 2 ? -1 : 1) * (size - excess);
    p[from.right] = static_cast<int>(from.right_sign) * right;
    p[from.up] = static_cast<int>(from.up_sign) * up;

    int axis = face / 2;
    if (excess > 0) axis = std::abs(right) == size ? from.right : from.up;
    const int landed = 2 * axis + (p[axis] < 0);
    const CubeFaceAxes& to = kCubeFaces[landed];
    const int column = static_cast<int>(to.right_sign) * p[to.right], row = static_cast<int>(to.up_sign) * p[to.up];
    return {landed, (column + size - 1) / 2, (size - 1 - row) / 2};
}

double cube_solid_angle(double x0, double x1, double y0, double y1) {
    const auto corner = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0)); };
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

}  // namespace burnish
