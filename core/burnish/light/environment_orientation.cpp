#include <burnish/light/environment_orientation.h>

namespace burnish {
namespace {

/// Right-hand turn about the up axis, as a function of a column vector.
Vec3f turned(const Vec3f& d, UpAxis up, double c, double s) {
    const auto mix = [](double a, float x, double b, float y) { return static_cast<float>(a * x + b * y); };
    if (up == UpAxis::z) return {mix(c, d.x, -s, d.y), mix(s, d.x, c, d.y), d.z};
    return {mix(c, d.x, s, d.z), d.y, mix(-s, d.x, c, d.z)};
}

Vec3f to_picture(const Vec3f& t, bool blender_latlong, UpAxis up) {
    if (up == UpAxis::z) return blender_latlong ? Vec3f(t.y, t.z, t.x) : Vec3f(t.x, t.z, -t.y);
    return blender_latlong ? Vec3f(-t.z, t.y, t.x) : t;
}

}  // namespace

Matrix33f world_to_light_matrix(EnvironmentConvention convention, UpAxis up, float rotate_deg, bool flip, bool is_cube) {
    const double angle = std::numbers::pi / 180.0 * rotate_deg, c = std::cos(angle), s = std::sin(angle);
    const bool blender_latlong = !is_cube && convention == EnvironmentConvention::blender;
    Matrix33f m;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3f d(0.0f);
        d[axis] = 1.0f;
        const Vec3f light = to_picture(turned(d, up, c, s), blender_latlong, up);
        for (int k = 0; k < 3; ++k) m[axis][k] = k == 0 && flip ? -light[k] : light[k];
    }
    return m;
}

}  // namespace burnish
