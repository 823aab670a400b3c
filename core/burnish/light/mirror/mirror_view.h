// Where rays end in a picture that knows what place each of its pixels shows (Walkthrough 4.5.2).
//
// A ray that leaves a mirror near the mirrored view of p meets, as a first guess, the tangent plane of what the picture shows at
// p. Where that guess lies in the picture another surface may be seen: there the ray is met with the surface found, again, so that
// rays which just miss an object end on what stands behind it. Planes are those of single pixels, so flat surfaces are exact.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/camera.h>

namespace burnish {

class MirrorView {
public:
    MirrorView() = default;
    /// Of a picture with `data` pixels: each one's place and unit normal, world space. Places that are no hits (sightings.h)
    /// are infinitely far away.
    MirrorView(const Camera& camera, const Window& data, const Window& display, const Image& position, const Image& normal);

    struct Found {
        Vec2f place{0, 0};   // pixels of the data window, centres at + 0.5; NaN: not in front of the camera
        float nearness = 0;  // 1 / distance from p to what is seen; 0: infinitely far
        Vec3f across, down;  // of `place` by the ray's direction, pixels per radian
        float miss = 0;      // pixels from `place` to where the ray meets the surface seen there
    };
    /// `steps`: how often the surface that was found is met, 1 or more.
    Found find(const Vec3f& p, const Vec3f& d, int steps) const;
    static bool is_seen(const Found& found) { return found.place.x == found.place.x; }

    const Vec3f& centre() const { return m_centre; }

private:
    /// What a pixel shows: points x with n . (x - centre) = offset. n = 0: the infinitely far.
    struct Facet {
        Vec3f n;
        float offset;
    };

    Vec2f project(const Vec3f& from_centre) const;
    const Facet& facet(const Vec2f& place) const;
    Found meet(const Vec3f& from, const Vec3f& d, const Facet& facet) const;

    Vec3f m_centre;
    Vec3f m_x, m_y, m_z;  // pixel (x, y) of a point q from the centre: (m_x . q, m_y . q) / (m_z . q)
    int m_width = 0, m_height = 0;
    std::vector<Facet> m_facets;
};

}  // namespace burnish
