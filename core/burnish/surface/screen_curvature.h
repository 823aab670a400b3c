// How curved the surface is at a pixel, from what its neighbours know: the scale between a step on the screen and the turn of
// the normal, and so of what is reflected.
//
// A step on the screen moves the normal by dn and the point on the surface by dP. Curvature is the largest |dn| / |dP| over the
// directions of the step, the root of the larger eigenvalue of (dP^T dP)^-1 dn^T dn.
//
// dn is smoothed over 3 x 3 pixels and never reaches over the edge of a surface. dP is not measured, as positions far from the
// origin are too coarse in half float: it is the pixel's cone, d' times its angle, cut by the plane across n. Only where the
// camera has no rays it comes from positions, never below the cone. What turns per pixel is then as exact as the normals are,
// bump maps included: a mapped normal curves as much as it shades.
#pragma once

#include <burnish/surface/surfaces.h>

namespace burnish {

class ScreenCurvature {
public:
    /// All three must outlive this and belong together.
    ScreenCurvature(const AovFrame& frame, const Assignment& assignment, const Surfaces& surfaces);

    /// 1/unit, >= 0, finite; 0 where the pixel is not valid or stands alone. Thread-safe.
    float at(size_t pixel) const;
    const Vec3f& eye() const { return m_camera.centre; }
    /// Radians between the rays of neighbouring pixels, across or down, whichever is more; 0 for a frame without surfaces.
    float pixel_angle() const { return m_pixel_angle; }

private:
    /// The change of a vector per pixel to the right and down.
    struct Change {
        Vec3f x{0, 0, 0}, y{0, 0, 0};
    };
    /// A symmetric 2 x 2 matrix.
    struct Form {
        float xx, xy, yy;
    };
    /// Which of the 3 x 3 pixels around one lie on its surface.
    using Neighbours = std::array<std::array<bool, 3>, 3>;

    struct Seen {
        Vec3f p, n, wo;
        float distance;
    };
    Seen seen(size_t pixel) const;
    bool same_surface(size_t a, const Seen& at_a, size_t b) const;
    Neighbours neighbours(size_t pixel, const Seen& here) const;
    Change change_of(const Image& layer, bool unit, size_t pixel, const Neighbours& around) const;
    Form footprint(size_t pixel, const Seen& here, const Neighbours& around) const;
    float angle_of_positions() const;

    const Surfaces& m_surfaces;
    const Assignment& m_assignment;
    const Camera& m_camera;
    const Image &m_position, &m_normal;
    const Image *m_object_id, *m_material_id;
    Vec3f m_forward, m_right, m_down;  // of the camera; change of its rays (planar depth 1) from pixel to pixel
    float m_pixel_angle;
};

/// `at` of every pixel: one channel.
Image screen_curvature(const ScreenCurvature& curvature, int width, int height);

}  // namespace burnish
