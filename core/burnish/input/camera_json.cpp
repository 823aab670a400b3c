#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
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
                                                   "matrix_world", "shift",           "sensor_fit", "fov",       "type",
                                                   "lens_mm",      "sensor_width_mm", "clip_start", "clip_end",  "convention"};
constexpr std::array<std::string_view, 3> kSensorFits{"AUTO", "HORIZONTAL", "VERTICAL"};
constexpr std::array<std::string_view, 1> kTypes{"PERSP"};
constexpr double kLargest = 1e12;  // of coordinates

[[noreturn]] void fail(const std::string& field, const std::string& reason) {
    throw Error(ErrorCode::bad_argument, field + ": " + reason);
}

template <size_t n>
std::array<double, n> numbers(const json& value, const std::string& field) {
    const auto usable = [](const json& x) { return x.is_number() && std::fabs(x.get<double>()) <= kLargest; };
    if (!value.is_array() || value.size() != n || !std::all_of(value.begin(), value.end(), usable))
        fail_expected(field, "a list of " + std::to_string(n) + " numbers", value);
    std::array<double, n> result;
    std::transform(value.begin(), value.end(), result.begin(), [](const json& x) { return x.get<double>(); });
    return result;
}

Imath::V3d vector(const JsonFields& fields, const char* name) {
    const auto v = numbers<3>(fields.at(name), fields.path(name));
    return {v[0], v[1], v[2]};
}

/// Where the camera stands and its unit axes: right, up, forward.
struct Pose {
    Imath::V3d centre, right, up, forward;
};

Pose pose_from_matrix(const JsonFields& fields) {
    const std::string field = fields.path("matrix_world");
    const json& matrix = fields.at("matrix_world");
    if (!matrix.is_array() || matrix.size() != 4) fail_expected(field, "4 rows of 4 numbers", matrix);
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

Pose pose_from_target(const JsonFields& fields) {
    Pose pose{vector(fields, "position"), {}, {}, {}};
    if (!fields.has("look_at")) fail(fields.path("look_at"), "missing; a camera by position alone has no other field");
    if (!fields.has("up")) fail(fields.path("up"), "missing; [0,0,1] in Blender and 3ds Max, [0,1,0] in most others");
    pose.forward = vector(fields, "look_at") - pose.centre;
    if (!(pose.forward.length() > 0)) fail(fields.path("look_at"), "is the same point as position");
    pose.forward.normalize();
    pose.right = pose.forward.cross(vector(fields, "up"));
    if (!(pose.right.length() > 1e-9)) fail(fields.path("up"), "is parallel to the viewing direction");
    pose.right.normalize();
    pose.up = pose.right.cross(pose.forward);
    return pose;
}

/// Tangent of half the angle in `name`; 0 when absent.
double tan_half(const JsonFields& fields, const char* name) {
    constexpr NumberRange kDegrees{0.001, 179.9};
    return fields.has(name) ? std::tan(fields.number(name, kDegrees) * std::numbers::pi / 360) : 0;
}

/// Half extents of the image plane at depth 1.
std::array<double, 2> half_extents(const JsonFields& fields, double aspect) {
    constexpr std::array<std::string_view, 2> kSameAngle{"fov", "fov_x_deg"};
    fields.expect_at_most_one(kSameAngle);
    const double x = tan_half(fields, fields.has("fov") ? "fov" : "fov_x_deg"), y = tan_half(fields, "fov_y_deg");
    if (x == 0 && y == 0) fail(fields.path("fov_x_deg"), "missing; the horizontal angle of view in degrees");
    if (x != 0 && y != 0 && std::fabs(x / y / aspect - 1) > 0.01)
        fail(fields.path("fov_y_deg"), "with fov_x_deg it gives an aspect of " + std::to_string(x / y) + ", the image has " +
                                           std::to_string(aspect) + "; give one of the two, and the camera of this image");
    return {x != 0 ? x : y * aspect, y != 0 ? y : x / aspect};
}

/// Lens shift in half extents of the image plane.
std::array<double, 2> shift_of(const JsonFields& fields, double aspect) {
    const std::string fit = fields.has("sensor_fit") ? fields.name("sensor_fit", kSensorFits) : "AUTO";
    if (!fields.has("shift")) return {0, 0};
    const auto shift = numbers<2>(fields.at("shift"), fields.path("shift"));
    const bool vertical = fit == "VERTICAL" || (fit == "AUTO" && aspect < 1);
    return vertical ? std::array{2 * shift[0] / aspect, 2 * shift[1]} : std::array{2 * shift[0], 2 * shift[1] * aspect};
}

}  // namespace

Camera camera_from_json(const json& object, const std::string& where, float aspect) {
    constexpr std::array<std::string_view, 2> kPlaces{"position", "matrix_world"};
    const JsonFields fields(object, where);
    fields.expect_only(kFields);
    fields.expect_at_most_one(kPlaces);
    if (fields.has("type")) fields.name("type", kTypes);
    const bool matrix = fields.has("matrix_world");
    if (!matrix && !fields.has("position")) fail(where, "needs position (with look_at, up, fov_x_deg) or matrix_world");

    Camera camera;
    camera.source = "json";
    if (!matrix && object.size() == 1) {
        camera.centre = Vec3f(vector(fields, "position"));
        return camera;
    }
    const Pose pose = matrix ? pose_from_matrix(fields) : pose_from_target(fields);
    const auto [x, y] = half_extents(fields, aspect);
    const auto [shift_x, shift_y] = shift_of(fields, aspect);
    const Imath::V3d right = pose.right * x, up = pose.up * y;
    camera.centre = Vec3f(pose.centre);
    camera.axis = Vec3f(pose.forward + right * shift_x + up * shift_y);
    camera.right = Vec3f(right);
    camera.up = Vec3f(up);
    camera.has_rays = true;
    return camera;
}

}  // namespace burnish
