#include <burnish/base/error.h>
#include <burnish/input/camera_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 15> kFields{"position",     "look_at",         "up",         "fov_x_deg", "fov_y_deg",
                                                   "matrix_world", "shift",           "sensor_fit", "type",      "lens_mm",
                                                   "fov",          "sensor_width_mm", "clip_start", "clip_end",  "convention"};

[[noreturn]] void fail(const std::string& field, const std::string& reason) {
    throw Error(ErrorCode::bad_argument, field + ": " + reason);
}

double number(const json& value, const std::string& field) {
    if (!value.is_number()) fail(field, "expected a number, found " + std::string(value.type_name()));
    const double x = value.get<double>();
    if (!std::isfinite(x) || std::fabs(x) > 1e12) fail(field, "out of range");
    return x;
}

template <size_t n>
std::array<double, n> numbers(const json& value, const std::string& field) {
    if (!value.is_array() || value.size() != n) fail(field, "expected " + std::to_string(n) + " numbers in brackets");
    std::array<double, n> result;
    for (size_t i = 0; i < n; ++i) result[i] = number(value[i], field + "[" + std::to_string(i) + "]");
    return result;
}

Imath::V3d vector(const json& object, const char* name, const std::string& where) {
    const auto v = numbers<3>(object[name], where + "." + name);
    return {v[0], v[1], v[2]};
}

/// Where the camera stands and its unit axes: right, up, forward.
struct Pose {
    Imath::V3d centre, right, up, forward;
};

Pose pose_from_matrix(const json& object, const std::string& where) {
    const std::string field = where + ".matrix_world";
    const json& matrix = object["matrix_world"];
    if (!matrix.is_array() || matrix.size() != 4) fail(field, "expected 4 rows of 4 numbers");
    std::array<std::array<double, 4>, 4> m;
    for (size_t row = 0; row < 4; ++row) m[row] = numbers<4>(matrix[row], field + "[" + std::to_string(row) + "]");
    if (m[3] != std::array<double, 4>{0, 0, 0, 1})
        fail(field, "the last row must be 0 0 0 1 (translation belongs in the last column)");

    Pose pose{
        {m[0][3], m[1][3], m[2][3]}, {m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {-m[0][2], -m[1][2], -m[2][2]}};
    for (Imath::V3d* axis : {&pose.right, &pose.up, &pose.forward}) {
        if (!(axis->length() > 1e-9)) fail(field, "a column of the rotation is zero");
        axis->normalize();
    }
    const double skew = std::max(
        {std::fabs(pose.right.dot(pose.up)), std::fabs(pose.up.dot(pose.forward)), std::fabs(pose.forward.dot(pose.right))});
    if (skew > 1e-3) fail(field, "the columns are not perpendicular; a camera can turn and move, not shear");
    return pose;
}

Pose pose_from_target(const json& object, const std::string& where) {
    Pose pose{vector(object, "position", where), {}, {}, {}};
    if (!object.contains("look_at")) fail(where + ".look_at", "missing; a camera by position alone has no other field");
    if (!object.contains("up")) fail(where + ".up", "missing; [0,0,1] in Blender and 3ds Max, [0,1,0] in most others");
    pose.forward = vector(object, "look_at", where) - pose.centre;
    if (!(pose.forward.length() > 0)) fail(where + ".look_at", "is the same point as position");
    pose.forward.normalize();
    pose.right = pose.forward.cross(vector(object, "up", where));
    if (!(pose.right.length() > 1e-9)) fail(where + ".up", "is parallel to the viewing direction");
    pose.right.normalize();
    pose.up = pose.right.cross(pose.forward);
    return pose;
}

/// Tangent of half the angle in `name`; 0 when absent.
double tan_half(const json& object, const char* name, const std::string& where) {
    if (!object.contains(name)) return 0;
    const std::string field = where + "." + name;
    const double degrees = number(object[name], field);
    if (!(degrees > 0 && degrees < 180)) fail(field, "must lie between 0 and 180 degrees");
    return std::tan(degrees * std::numbers::pi / 360);
}

/// Half extents of the image plane at depth 1.
std::array<double, 2> half_extents(const json& object, const std::string& where, double aspect) {
    const double x = tan_half(object, object.contains("fov") ? "fov" : "fov_x_deg", where);
    const double y = tan_half(object, "fov_y_deg", where);
    if (x == 0 && y == 0) fail(where + ".fov_x_deg", "missing; the horizontal angle of view in degrees");
    if (x != 0 && y != 0 && std::fabs(x / y / aspect - 1) > 0.01)
        fail(where + ".fov_y_deg", "with fov_x_deg it gives an aspect of " + std::to_string(x / y) + ", the image has " +
                                       std::to_string(aspect) + "; give one of the two, and the camera of this image");
    return {x != 0 ? x : y * aspect, y != 0 ? y : x / aspect};
}

/// Lens shift in half extents of the image plane.
std::array<double, 2> shift_of(const json& object, const std::string& where, double aspect) {
    if (!object.contains("shift")) return {0, 0};
    const auto shift = numbers<2>(object["shift"], where + ".shift");
    const std::string fit = object.value("sensor_fit", json("AUTO")).dump();
    const bool vertical = fit == "\"VERTICAL\"" || (fit == "\"AUTO\"" && aspect < 1);
    if (!vertical && fit != "\"HORIZONTAL\"" && fit != "\"AUTO\"")
        fail(where + ".sensor_fit", "expected HORIZONTAL, VERTICAL or AUTO, found " + fit);
    return vertical ? std::array{2 * shift[0] / aspect, 2 * shift[1]} : std::array{2 * shift[0], 2 * shift[1] * aspect};
}

void check_fields(const json& object, const std::string& where) {
    if (!object.is_object()) fail(where, "expected an object in braces, found " + std::string(object.type_name()));
    for (const auto& [name, value] : object.items())
        if (std::find(kFields.begin(), kFields.end(), name) == kFields.end())
            fail(where + "." + name,
                 "is not a field of a camera; fields: position, look_at, up, matrix_world, fov_x_deg, "
                 "fov_y_deg, shift, sensor_fit");
    if (object.contains("type") && object["type"] != "PERSP")
        fail(where + ".type", "only perspective cameras (PERSP), found " + object["type"].dump());
}

}  // namespace

Camera camera_from_json(const json& object, const std::string& where, float aspect) {
    check_fields(object, where);
    Camera camera;
    camera.source = "json";
    const bool matrix = object.contains("matrix_world");
    if (!matrix && !object.contains("position")) fail(where, "needs position (with look_at, up, fov_x_deg) or matrix_world");
    if (matrix && object.contains("position")) fail(where, "has both position and matrix_world; give one");
    if (!matrix && object.size() == 1) {
        camera.centre = Vec3f(vector(object, "position", where));
        return camera;
    }

    const Pose pose = matrix ? pose_from_matrix(object, where) : pose_from_target(object, where);
    const auto [x, y] = half_extents(object, where, aspect);
    const auto [shift_x, shift_y] = shift_of(object, where, aspect);
    const Imath::V3d right = pose.right * x, up = pose.up * y;
    camera.centre = Vec3f(pose.centre);
    camera.axis = Vec3f(pose.forward + right * shift_x + up * shift_y);
    camera.right = Vec3f(right);
    camera.up = Vec3f(up);
    camera.has_rays = true;
    return camera;
}

}  // namespace burnish
