// A pinhole camera as shading needs it: where it stands, and the ray through a point of the display window.
//
//     P(sx, sy, Z) = centre + Z (axis + sx right + sy up),   sx in [-1, 1] left to right, sy in [-1, 1] bottom to top
//
// `axis` is the unit viewing direction plus the lens shift, so Z is planar depth (distance along the viewing direction).
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <optional>
#include <string>

namespace burnish {

struct Camera {
    Vec3f centre{0, 0, 0};              // world space, scene units
    Vec3f axis{0, 0, -1};               // ray through the middle of the display window at planar depth 1
    Vec3f right{1, 0, 0}, up{0, 1, 0};  // half extents of the image plane at planar depth 1
    bool has_rays = false;              // false when only the centre is known
    std::string source;                 // "json", "header", "recovered from position", for the report

    /// Ray at planar depth 1 through the screen point s in [-1, 1]^2; not unit length.
    Vec3f ray(const Vec2f& s) const { return axis + right * s.x + up * s.y; }

    /// Unit viewing direction: perpendicular to `right` and `up`, on the side of `axis`.
    Vec3f forward() const;

    /// Screen point of the world point p; nothing when p is not in front of the camera.
    std::optional<Vec2f> project(const Vec3f& p) const;
};

/// Screen point of the middle of pixel (x, y), in the coordinates of the file: (x + 0.5 - display.x) / display.width, and
/// the same downwards.
Vec2f screen_point(int x, int y, const Window& display);

}  // namespace burnish
