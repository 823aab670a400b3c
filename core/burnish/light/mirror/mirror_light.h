// The room as a mirror shows it, or what lies behind a pane: a render from behind the mirror's plane, or through the pane.
//
// The perfect mirror direction is exact at every point of the plane. Other rays end where MirrorView finds them, and a cone
// becomes a Gaussian as wide as it is there, seen from the picture's camera. What the picture cannot know it does not cover: what
// lies outside its edges, or on the side of the plane where its camera is, or behind what it sees there.
#pragma once

#include <burnish/light/filter/planar_stack.h>
#include <burnish/light/light_ray.h>
#include <burnish/light/mirror/mirror_buffer.h>
#include <burnish/light/mirror/mirror_view.h>

#include <span>

namespace burnish {

class MirrorLight {
public:
    /// `gain` multiplies radiance. Throws Error(bad_argument).
    MirrorLight(const MirrorBuffer& buffer, const MirrorSettings& settings, const Color3f& gain = Color3f(1, 1, 1));

    void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;
    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const { return false; }
    LightDraw sample(const Vec3f&, const Vec2f&) const { return {}; }
    float mean_luminance() const { return m_mean; }

private:
    Incident incident(const LightRay& ray) const;

    MirrorView m_view;
    PlanarStack m_light;
    Vec3f m_away;  // unit normal of the plane, away from the picture's camera
    int m_steps;
    float m_mean;  // luminance of what the picture knows
};

}  // namespace burnish
