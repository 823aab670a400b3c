#include <burnish/input/header_camera.h>
#include <burnish/input/median.h>
#include <burnish/input/metadata.h>
#include <burnish/input/sightings.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

namespace burnish {
namespace {

using Imath::V2d, Imath::V3d, Imath::M44d;

constexpr size_t kSightings = 1000;
constexpr size_t kFewest = 50;  // interior pixels: fewer say too little to check a camera
constexpr double kTolerance_px = 0.5;
constexpr double kFovTolerance = 0.02;  // relative, between the header's angle of view and the one seen in position

/// Where a camera stands and its unit axes.
struct Pose {
    V3d centre, right, up, forward;
    const char* reading;
};

V3d row(const M44d& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }

/// Rotation, uniform scale and translation, nothing else; a matrix of zeros or a projection is not.
bool is_rigid(const M44d& m) {
    const double length = row(m, 0).length();
    if (!(length > 1e-9) || !std::isfinite(length) || !std::isfinite(row(m, 3).length())) return false;
    const auto close = [length](double x, double y) { return std::fabs(x - y) < 1e-3 * length * length; };
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!close(row(m, i).dot(row(m, j)), i == j ? length * length : 0)) return false;
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

/// All readings of the matrix that are in use, the likeliest first.
std::vector<Pose> readings(const CameraHeader& header) {
    const M44d m(*header.matrix), inverse = m.inverse();
    const auto unit = [](const M44d& from, int i, double sign) { return row(from, i).normalized() * sign; };
    const Pose standard{row(inverse, 3), unit(inverse, 0, 1), unit(inverse, 1, 1), unit(inverse, 2, 1), "world to camera"};
    const Pose backward{row(inverse, 3), unit(inverse, 0, 1), unit(inverse, 1, 1), unit(inverse, 2, -1),
                        "world to camera, -Z forward"};
    const Pose vray{row(m, 3), unit(m, 0, 1), unit(m, 2, -1), unit(m, 1, -1), "V-Ray's camera to world"};
    const Pose to_world{row(m, 3), unit(m, 0, 1), unit(m, 1, 1), unit(m, 2, -1), "camera to world"};
    if (header.vray) return {vray, to_world, backward, standard};
    if (m.determinant() < 0) return {standard, vray, to_world, backward};
    return {backward, vray, to_world, standard};
}

/// y = slope x + offset, with the median distance of the points from it.
struct Line {
    double slope = 0, offset = 0, misfit = std::numeric_limits<double>::infinity();
};

/// Line by repeated medians of far pairs; half the points may be wrong.
Line robust_line(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> slopes, offsets, misfits;
    for (size_t step : {x.size() / 2, x.size() / 3, x.size() / 5, size_t{7}, size_t{1}})
        for (size_t i = 0; i + step < x.size(); ++i)
            if (std::fabs(x[i + step] - x[i]) > 1e-3) slopes.push_back((y[i + step] - y[i]) / (x[i + step] - x[i]));
    if (slopes.empty()) return {};
    Line line;
    line.slope = median(slopes);
    for (size_t i = 0; i < x.size(); ++i) offsets.push_back(y[i] - line.slope * x[i]);
    line.offset = median(offsets);
    for (double offset : offsets) misfits.push_back(std::fabs(offset - line.offset));
    line.misfit = median(misfits);
    return line;
}

/// A pose with the angle of view and lens shift that position shows: (X/Z, Y/Z) is linear in the screen point.
struct Seen {
    Line x, y;
    double residual_px = std::numeric_limits<double>::infinity();
};

Seen see(const Pose& pose, const std::vector<Sighting>& sightings, const Window& display) {
    std::vector<double> sx, sy, x, y;
    for (const Sighting& s : sightings) {
        const V3d d = s.point - pose.centre;
        const double z = d.dot(pose.forward);
        if (!(z > 0)) continue;
        sx.push_back(s.screen.x), x.push_back(d.dot(pose.right) / z);
        sy.push_back(s.screen.y), y.push_back(d.dot(pose.up) / z);
    }
    if (2 * sx.size() < sightings.size()) return {};
    Seen seen{robust_line(sx, x), robust_line(sy, y)};
    if (!(seen.x.slope > 0 && seen.y.slope > 0)) return {};
    seen.residual_px =
        std::hypot(seen.x.misfit / seen.x.slope * display.width / 2, seen.y.misfit / seen.y.slope * display.height / 2);
    return seen;
}

Camera make_camera(const Pose& pose, const Line& x, const Line& y) {
    Camera camera;
    camera.centre = Vec3f(pose.centre);
    camera.axis = Vec3f(pose.forward + pose.right * x.offset + pose.up * y.offset);
    camera.right = Vec3f(pose.right * x.slope);
    camera.up = Vec3f(pose.up * y.slope);
    camera.has_rays = true;
    camera.source = "header";
    return camera;
}

std::optional<Camera> validated(const CameraHeader& header, const std::vector<Sighting>& sightings, const Window& display,
                                std::string& note) {
    char text[200];
    Seen seen;
    double nearest_px = std::numeric_limits<double>::infinity();
    const std::vector<Pose> poses = readings(header);
    const auto pose = std::find_if(poses.begin(), poses.end(), [&](const Pose& candidate) {
        seen = see(candidate, sightings, display);
        nearest_px = std::min(nearest_px, seen.residual_px);
        return seen.residual_px < kTolerance_px;
    });
    if (pose == poses.end()) {
        std::snprintf(text, sizeof(text),
                      "the header's camera does not fit the position layer (its median pixel is %.3g px off) and is not used",
                      nearest_px);
        return note = text, std::nullopt;
    }
    const double seen_fov = 360 / std::numbers::pi * std::atan(seen.x.slope);
    if (header.fov_x_deg && std::fabs(seen_fov / *header.fov_x_deg - 1) > kFovTolerance) {
        std::snprintf(
            text, sizeof(text),
            "the header's angle of view (%.2f degrees) is not that of the position layer (%.2f); its camera is not used",
            *header.fov_x_deg, seen_fov);
        return note = text, std::nullopt;
    }
    std::snprintf(text, sizeof(text), "camera from the header (%s), which fits the position layer to %.2g px", pose->reading,
                  seen.residual_px);
    note = text;
    return make_camera(*pose, seen.x, seen.y);
}

/// The likeliest reading; `reason` says why it cannot be checked.
Camera trusted(const CameraHeader& header, double aspect, const std::string& reason, std::string& note) {
    const Pose pose = readings(header).front();
    note = std::string("camera from the header, read as ") + pose.reading + " and not checked: " + reason;
    if (header.fov_x_deg) {
        const double half = std::tan(*header.fov_x_deg * std::numbers::pi / 360);
        return make_camera(pose, {half, 0, 0}, {half / aspect, 0, 0});
    }
    Camera camera = make_camera(pose, {1, 0, 0}, {1, 0, 0});
    camera.has_rays = false;
    return camera;
}

std::optional<double> first_number(const Metadata& metadata, std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const auto value = number_attribute(metadata, name); value && *value > 0) return value;
    return std::nullopt;
}

}  // namespace

CameraHeader camera_header(const Metadata& metadata) {
    CameraHeader header;
    for (const char* name : {"worldToCamera", "worldtocamera"})
        if (!header.matrix) header.matrix = matrix_attribute(metadata, name);
    for (const std::string& name : attribute_names(metadata)) header.vray |= name.rfind("vrayInfo/", 0) == 0;

    header.fov_x_deg = first_number(metadata, {"CameraFov", "cameraFov"});
    const auto focal = first_number(metadata, {"CameraFocalLength", "cameraFocalLength"});
    const auto aperture = first_number(metadata, {"CameraFilmApertureHorizontal", "cameraAperture"});
    if (!header.fov_x_deg && focal && aperture) header.fov_x_deg = 360 / std::numbers::pi * std::atan(*aperture / (2 * *focal));
    if (header.fov_x_deg && *header.fov_x_deg >= 180) header.fov_x_deg.reset();
    return header;
}

std::optional<Camera> header_camera(const CameraHeader& header, const Image* position, const Image* valid,
                                    const RowStrips& rows, const Window& display, float pixel_aspect, std::string& note) {
    note.clear();
    if (!header.matrix) return std::nullopt;
    if (!is_rigid(M44d(*header.matrix)))
        return note = "the header's camera matrix is not a rotation and translation and is not used", std::nullopt;
    const double aspect = static_cast<double>(pixel_aspect) * display.width / display.height;
    if (!position) return trusted(header, aspect, "there is no position layer", note);
    const std::vector<Sighting> sightings = sample_sightings(*position, valid, rows, display, kSightings);
    if (sightings.size() < kFewest) return trusted(header, aspect, "too few pixels see a surface", note);
    return validated(header, sightings, display, note);
}

}  // namespace burnish
