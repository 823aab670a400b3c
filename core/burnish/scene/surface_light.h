// The light that leaves a scene's surfaces: baked light maps, albedo and emission. View-dependent light is not the scene's business.
#pragma once

#include <burnish/base/image.h>
#include <burnish/scene/trace.h>

#include <memory>

namespace burnish {

/// RGB pictures over the scene's texture coordinates: u right, v up, texel centres at + 0.5, bilinear, clamped at the edges; linear.
struct LightMaps {
    Image radiance = {};    // what leaves the surface's front, emission included; empty = from irradiance
    Image irradiance = {};  // irradiance / pi; empty = none
    Image albedo = {};      // diffuse reflectance; empty = the objects' own
    /// How often the largest map may be halved for wide lookups; smaller ones stop at the same size. Light maps are atlases with
    /// few texels between their charts: a map halved n times mixes what lies 1.5 * 2^n texels apart.
    int halvings = 2;
};

class SurfaceLight {
public:
    /// The scene must outlive it. Throws Error(bad_argument) for maps that are not RGB.
    SurfaceLight(const Scene& scene, LightMaps maps);

    const Scene& scene() const { return *m_scene; }

    /// What leaves `hit` towards where its ray came from, averaged over a disc `diameter` scene units wide on the surface (0: one
    /// point), as far as the halvings go: the radiance map, or albedo * irradiance + emission. Emission leaves on the front only.
    /// Thread-safe.
    Color3f radiance(const Hit& hit, float diameter = 0) const;
    /// Irradiance / pi there, from its map; 0 without one.
    Color3f irradiance(const Hit& hit, float diameter = 0) const;
    Color3f albedo(const Hit& hit, float diameter = 0) const;
    /// The widest disc that lookups at `hit` average without leaving anything out, scene units; 0 where there are no maps.
    float widest(const Hit& hit) const;

private:
    struct Pyramids;
    const Scene* m_scene;
    std::shared_ptr<const Pyramids> m_pyramids;
};

}  // namespace burnish
