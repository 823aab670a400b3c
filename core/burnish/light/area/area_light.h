// A flat convex polygon that shines: a softbox, a ceiling panel, a screen, a window.
//
// A cone of rays sees the share of its Gaussian that lies in the polygon (seen_polygon.h) and, where the lamp is a picture, that
// picture's mean over the cone's footprint on the lamp's plane. What lies below the horizon of the surface is not seen, so that
// no lamp shines through from behind. Points behind a one-sided lamp, or in its plane, see nothing.
// `exact` is the hit of the ray alone; directions are drawn uniformly over what is seen, or by the picture's luminance.
#pragma once

#include <burnish/light/area/area_nodes.h>
#include <burnish/light/area/area_picture.h>
#include <burnish/light/area/seen_polygon.h>
#include <burnish/light/light_ray.h>
#include <burnish/light/light_settings.h>

#include <functional>
#include <memory>
#include <span>

namespace burnish {

class AreaLight {
public:
    /// `gain` multiplies radiance. `picture`: RGB, finite, >= 0, over a parallelogram; empty = none, whatever settings.texture says.
    /// Throws Error(bad_argument) for what is no convex polygon, and for radiance that is not finite or negative.
    explicit AreaLight(const AreaSettings& settings, const Color3f& gain = Color3f(1, 1, 1), Image picture = {});
    /// With settings.texture read from its file. `convert`: as for Environment::load. Throws Error(read_failed | bad_argument).
    static AreaLight load(const AreaSettings& settings, const Color3f& gain = Color3f(1, 1, 1),
                          const std::function<void(Image&)>& convert = {});

    void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;
    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const { return true; }
    LightDraw sample(const Vec3f& p, const Vec2f& u) const;

    /// A few places that stand for the lamp, where what is shone on varies slowly over it; for what a point sees of it above its
    /// horizon, the plane across unit vector `up`, unless it is a picture. `own`: memory for them.
    std::span<const AreaNode> nodes_above(const Vec3f& p, const Vec3f& up, std::vector<AreaNode>& own) const;
    const ConvexPolygon& polygon() const { return m_polygon; }
    const Color3f& radiance() const { return m_radiance; }  // without the picture
    /// Of the picture, 1 without one.
    const Color3f& mean_colour() const { return m_mean; }
    bool is_solid() const { return !m_picture; }
    bool is_two_sided() const { return m_two_sided; }

private:
    struct Hit {
        float distance, cosine;  // cosine: of the angle to the normal, > 0
        Vec2f uv;                // of the picture
    };
    bool shines_to(const Vec3f& p) const { return m_two_sided || m_polygon.height(p) > 0; }
    Incident incident(const LightRay& ray, const SeenPolygon& seen) const;
    PictureEllipse footprint(const LightRay& ray, const Vec3f& towards, float distance) const;
    Vec2f uv(const Vec3f& place) const {
        return {m_u.dot(place - m_polygon.corners[0]), m_v.dot(place - m_polygon.corners[0])};
    }
    float pdf(const Vec3f& p, const Vec3f& d, float distance) const;

    ConvexPolygon m_polygon;
    Color3f m_radiance;  // gain included
    bool m_two_sided;
    std::shared_ptr<const AreaPicture> m_picture;  // null: solid
    Vec3f m_u{0, 0, 0}, m_v{0, 0, 0};              // gradients of u and v on the plane, per scene unit
    std::vector<AreaNode> m_nodes;
    Color3f m_mean{1, 1, 1};
};

}  // namespace burnish
