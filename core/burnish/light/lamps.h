// The brightest triangles of a scene, to be drawn from: where `reference` would otherwise wait for a lobe sample to hit a lamp.
#pragma once

#include <burnish/light/light_ray.h>
#include <burnish/light/sample_table.h>
#include <burnish/scene/surface_light.h>

#include <memory>
#include <optional>
#include <vector>

namespace burnish {

/// Triangles whose fronts are several times brighter than the scene is on the whole, drawn in proportion to their power.
class Lamps {
public:
    explicit Lamps(const SurfaceLight& light);

    bool empty() const { return m_weights.empty(); }
    /// A direction from p to a point on a lamp's front, whether or not something stands between.
    LightDraw sample(const Vec3f& p, const Vec2f& u) const;
    /// Density of `sample`, per steradian: of all fronts of lamps that lie along d.
    float pdf(const Vec3f& p, const Vec3f& d) const;

private:
    std::shared_ptr<const Scene> m_triangles;  // as one object
    std::optional<Tracer> m_tracer;
    SampleTable m_table;
    std::vector<float> m_weights;  // of each triangle: probability over area
};

}  // namespace burnish
