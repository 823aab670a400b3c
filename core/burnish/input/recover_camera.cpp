#include <burnish/input/median.h>
#include <burnish/input/recover_camera.h>
#include <burnish/input/resection.h>
#include <burnish/input/sightings.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace burnish {
namespace {

constexpr size_t kSightings = 3000;
constexpr size_t kFewest = 50;           // interior pixels: fewer say too little to check a camera
constexpr double kTolerance_px = 0.5;    // positions sampled anywhere in their pixel are good
constexpr double kWorstResidual_px = 2;  // of the median pixel: more is not a perspective view
constexpr double kFewestInliers = 0.55;
constexpr double kWorstCentre = 3e-3;  // of the distance: 3 milliradians in the viewing direction
constexpr double kWorstRelief = 1e-2;
constexpr const char* kRemedy = "; give the camera (setting camera, or a camera JSON)";

/// Extents of the point cloud along its principal axes, longest first.
Eigen::Vector3d extents(const std::vector<Imath::V3d>& points) {
    Eigen::Matrix<double, Eigen::Dynamic, 3> cloud(static_cast<Eigen::Index>(points.size()), 3);
    for (size_t i = 0; i < points.size(); ++i)
        cloud.row(static_cast<Eigen::Index>(i)) = Eigen::RowVector3d(points[i].x, points[i].y, points[i].z);
    cloud.rowwise() -= cloud.colwise().mean().eval();
    return (Eigen::Matrix3d(cloud.transpose() * cloud) / static_cast<double>(points.size()))
        .jacobiSvd()
        .singularValues()
        .cwiseSqrt();
}

Camera to_camera(const Resection& fit, const Window& display) {
    Imath::V3d right = fit.ray_u * (display.width / 2.0), up = fit.ray_v * (display.height / 2.0);
    const Imath::V3d plane = right.cross(up).normalized();
    const double depth = std::fabs(plane.dot(fit.ray_0));  // scales the rays to planar depth 1
    Camera camera;
    camera.centre = Vec3f(fit.centre);
    camera.axis = Vec3f(fit.ray_0 / depth);
    camera.right = Vec3f(right / depth);
    camera.up = Vec3f(up / depth);
    camera.has_rays = true;
    camera.source = "recovered from position";
    return camera;
}

/// Share of the points' relief, their smallest extent, that is noise. The predicted error takes noise for random, but on flat
/// surfaces rounding is not: all of a ceiling is rounded alike, and with it its height over the lamp that hangs there.
double noise_in_relief(const Resection& fit, const Camera& camera, const Window& display, const std::vector<Imath::V3d>& points,
                       double relief) {
    std::vector<double> depths;
    const Imath::V3d forward(camera.forward());
    for (const Imath::V3d& p : points) depths.push_back(forward.dot(p - fit.centre));
    return fit.residual * median(depths) * camera.right.length() / (display.width / 2.0) / relief;
}

/// Why a fit is no camera; empty when it is one.
std::string defect(const Resection& fit, const Camera& camera, const Window& display, const std::vector<Imath::V3d>& points) {
    const Eigen::Vector3d size = extents(points);
    const bool fits = fit.residual < kWorstResidual_px && fit.inliers >= kFewestInliers;
    const bool determined =
        fit.centre_error < kWorstCentre && noise_in_relief(fit, camera, display, points, size[2]) < kWorstRelief;
    if (fits && determined) return {};
    if (size[2] < 0.01 * size[0]) return "all visible points lie on one plane, so that many cameras would see the same";
    if (fits) return "the view is orthographic, or too nearly so";
    return "it is not what one perspective camera sees";
}

std::string refusal(const std::string& reason) {
    return "no camera can be recovered from the position layer: " + reason + kRemedy;
}

}  // namespace

std::optional<Camera> recover_camera(const Image& position, const RowStrips& rows, const Window& display, const Image* valid,
                                     std::string& note) {
    const std::vector<Sighting> sightings = sample_sightings(position, valid, rows, display, kSightings);
    if (sightings.size() < kFewest) return note = refusal("too few pixels see a surface"), std::nullopt;

    std::vector<Imath::V2d> pixels;  // from the middle of the display window, y up
    std::vector<Imath::V3d> points;
    for (const Sighting& s : sightings) {
        pixels.push_back(s.screen * Imath::V2d(display.width / 2.0, display.height / 2.0));
        points.push_back(s.point);
    }
    const Resection fit = resect(pixels, points, kTolerance_px);
    const Camera camera = to_camera(fit, display);
    if (const std::string reason = defect(fit, camera, display, points); !reason.empty())
        return note = refusal(reason), std::nullopt;

    char text[160];
    std::snprintf(text, sizeof(text),
                  "camera recovered from %zu positions: %.0f %% agree, median %.2g px, centre +- %.1g of the distance",
                  sightings.size(), 100 * fit.inliers, fit.residual, fit.centre_error);
    note = text;
    return camera;
}

}  // namespace burnish
