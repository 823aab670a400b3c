// The brightest triangles of a scene, to be drawn from: where `reference` would otherwise wait for a lobe sample to hit a lamp.
#pragma once

#include <burnish/light/light_ray.h>
#include <burnish/light/sample_table.h>
#include <burnish/scene/surface_light.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burnish {

/// Triangles whose fronts are several times brighter than the scene is on the whole, drawn in proportion to their power.
class Lamps {
public:
    explicit Lamps(const SurfaceLight& light);

    bool empty() const { return m_weights.empty(); }
    /// A part of a lamp's front, drawn as `sample` draws.
    struct Point {
        Vec3f p, n;        // n is the front's
        Color3f radiance;  // of the part
        float density;     // of all such points, per square scene unit
    };
    /// A few, always the same.
    std::span<const Point> points() const { return m_points; }
    /// Their density where the scene was hit, per square scene unit; 0 where that is no lamp's front.
    float density(const Hit& hit) const;

    /// A direction from p to a point on a lamp's front, whether or not something stands between.
    LightDraw sample(const Vec3f& p, const Vec2f& u) const;
    /// Density of `sample`, per steradian: of all fronts of lamps that lie along d.
    float pdf(const Vec3f& p, const Vec3f& d) const;

private:
    struct Drawn {
        Vec3f p;
        Vec2f uv;
        size_t triangle;
    };
    Drawn draw(const Vec2f& u) const;
    void make_points(const SurfaceLight& light);

    std::shared_ptr<const Scene> m_triangles;    // as one object
    std::vector<Hit> m_places;                   // in the scene, of each triangle
    std::vector<std::vector<float>> m_of_scene;  // m_weights, by object and triangle; empty for objects without lamps
    std::vector<Point> m_points;
    std::optional<Tracer> m_tracer;
    SampleTable m_table;
    std::vector<float> m_weights;  // of each triangle: probability over area
};

}  // namespace burnish
