#include <burnish/light/mirror/mirror_view.h>

#include <burnish/base/parallel.h>
#include <burnish/input/sightings.h>

#include <algorithm>
#include <limits>

namespace burnish {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
constexpr float kSettled = 0.05f;  // pixels

}  // namespace

MirrorView::MirrorView(const Camera& camera, const Window& data, const Window& display, const Image& position,
                       const Image& normal)
    : m_centre(camera.centre), m_width(data.width), m_height(data.height), m_facets(position.pixel_count()) {
    const Imath::V3d a(camera.axis), r(camera.right), u(camera.up);
    const double volume = a.dot(r.cross(u));
    const Imath::V3d x = u.cross(a) / volume, y = a.cross(r) / volume, z = r.cross(u) / volume;  // Camera::project
    m_x = Vec3f((x + z) * (0.5 * display.width) + z * (display.x - data.x));
    m_y = Vec3f((z - y) * (0.5 * display.height) + z * (display.y - data.y));
    m_z = Vec3f(z);
    for_each_index(data.height, [&](int row) {
        for (int column = 0; column < data.width; ++column) {
            const float *p = position.at(column, row), *n = normal.at(column, row);
            const Vec3f q = Vec3f(p[0], p[1], p[2]) - m_centre, toward = Vec3f(n[0], n[1], n[2]).normalized();
            Facet& facet = m_facets[static_cast<size_t>(row) * data.width + column];
            facet = {Vec3f(0, 0, 0), 0};
            if (!is_hit(p) || !is_finite(toward)) continue;
            facet.n = q.dot(toward) > 0 ? -toward : toward, facet.offset = q.dot(facet.n);
        }
    });
}

Vec2f MirrorView::project(const Vec3f& q) const {
    const float z = m_z.dot(q);
    if (!(z > 0)) return Vec2f(kNowhere);
    return {m_x.dot(q) / z, m_y.dot(q) / z};
}

/// Beyond the edges, what is seen at the edge goes on.
const MirrorView::Facet& MirrorView::facet(const Vec2f& place) const {
    const auto nearest = [](float at, int size) {
        return static_cast<size_t>(std::clamp(at, 0.0f, static_cast<float>(size) - 0.5f));
    };
    return m_facets[nearest(place.y, m_height) * m_width + nearest(place.x, m_width)];
}

MirrorView::Found MirrorView::find(const Vec3f& p, const Vec3f& d, int steps) const {
    const Vec3f from = p - m_centre;
    Found found;
    found.place = project(from);
    for (int i = 0; i < steps && is_seen(found); ++i) {
        const Vec2f before = found.place;
        found = meet(from, d, facet(before));
        found.miss = (found.place - before).length();
        if (found.miss < kSettled) return found;
    }
    if (is_seen(found)) found.miss = (meet(from, d, facet(found.place)).place - found.place).length();
    return found;
}

/// With k = 1/t the ray is at from + d/k, seen where q = k from + d is; k = -n . d / height there, 0 where the facet is not met.
MirrorView::Found MirrorView::meet(const Vec3f& from, const Vec3f& d, const Facet& facet) const {
    const float height = facet.n.dot(from) - facet.offset, descent = -facet.n.dot(d);
    const bool is_met = height > 0 && descent > 0;
    Found found;
    found.nearness = is_met ? descent / height : 0.0f;
    const Vec3f q = from * found.nearness + d, turn = is_met ? facet.n / height : Vec3f(0, 0, 0);
    found.place = project(q);
    const float z = m_z.dot(q);
    const auto gradient = [&](const Vec3f& axis, float at) {
        const Vec3f g = (axis - m_z * at) / z;
        return g - turn * g.dot(from);
    };
    found.across = gradient(m_x, found.place.x), found.down = gradient(m_y, found.place.y);
    return found;
}

}  // namespace burnish
