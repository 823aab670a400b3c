// The room itself as a light: rays are traced to its geometry, and read there what its surfaces send back.
//
// A lookup's cone is a bundle of rays, the same for every point but for the way it is turned: they lie where the Gaussian's mass is
// cut into equal parts, and each brings the mean over its own part from the light map's pyramid. `exact` is one ray, unfiltered.
#pragma once

#include <burnish/light/lit_scene.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

class TracedLight {
public:
    /// `rays`: of a bundle, 1 to 64. `gain` multiplies radiance. Throws Error(bad_argument).
    TracedLight(std::shared_ptr<const LitScene> scene, int rays, const Color3f& gain = Color3f(1, 1, 1));

    /// Cover is the share of the bundle that meets the scene. Bend follows from the range of light among its rays: it bounds what a
    /// Gaussian makes of any light within that range, and knows nothing of light between the rays that none of them met.
    void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;
    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const { return !m_scene->lamps().empty(); }
    /// Towards the scene's lamps.
    LightDraw sample(const Vec3f& p, const Vec2f& u) const { return m_scene->lamps().sample(p, u); }

private:
    class Start;
    struct Met {
        Color3f radiance{0, 0, 0};
        float cover = 0, nearness = 0;
    };
    Incident bundle(const Start& start, const LightRay& ray) const;
    /// What a ray towards d meets, averaged over a Gaussian `sigma` radian wide.
    Met meet(const Start& start, const Vec3f& d, float sigma) const;

    std::shared_ptr<const LitScene> m_scene;
    std::vector<Vec2f> m_bundle;  // places of the rays about d, in widths of the Gaussian
    float m_part;                 // width of a ray's own part, in widths of the Gaussian
    Color3f m_gain;
};

}  // namespace burnish
