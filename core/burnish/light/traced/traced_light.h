// The room itself as a light: rays are traced to its geometry, and read there what its surfaces send back.
//
// A lookup's cone is a bundle of rays, the same for every point but for the way it is turned; each brings the mean over its own part
// of the cone from the light map's pyramid. Such rays would hit or miss a small bright lamp by chance. So a direction that leads to a
// lamp may come from two sides, as a ray of the cone or as one of a few points of the lamps that all cones of a shaded point share,
// and counts by the power heuristic (Veach & Guibas 1995): with K rays of density g and M points of density q, a ray adds
// L / K (K g)^2 / ((K g)^2 + (M q)^2), a point L g / (M q) (M q)^2 / ((K g)^2 + (M q)^2). `exact` is one ray, unfiltered.
#pragma once

#include <burnish/light/traced/ray_bundle.h>
#include <burnish/light/traced/traced_start.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

class TracedLight {
public:
    /// `rays`: of a bundle, 1 to 64. `gain` multiplies radiance. Throws Error(bad_argument).
    TracedLight(std::shared_ptr<const LitScene> scene, int rays, const Color3f& gain = Color3f(1, 1, 1));

    /// Cover is the share of the bundle that meets the scene. Bend is that of the lamps' points, and follows for the rest from the
    /// range of light among the rays: it bounds what a Gaussian makes of any light within that range, and knows nothing of light
    /// between the rays that none of them met.
    void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;
    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const { return !m_scene->lamps().empty(); }
    /// Towards the scene's lamps.
    LightDraw sample(const Vec3f& p, const Vec2f& u) const { return m_scene->lamps().sample(p, u); }

    /// Of what rays from inside the scene's box meet.
    float mean_luminance() const { return m_mean * luminance(m_gain); }

private:
    Incident averaged(TracedStart& start, const LightRay& ray) const;

    std::shared_ptr<const LitScene> m_scene;
    RayBundle m_bundle;
    Color3f m_gain;
    float m_mean;
};

}  // namespace burnish
