// A mesh that stands for the room around a cube map, met by ray tracing: where rays end exactly.
#pragma once

#include <burnish/light/cube_map/ray_end.h>
#include <burnish/scene/trace.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

class ProxyMesh {
public:
    /// World space. Throws what Tracer does.
    ProxyMesh(std::shared_ptr<const Scene> scene, const Vec3f& centre);

    /// Rays start a little off the surface they leave, so that the mesh may hold the shaded objects, too.
    void ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const;

private:
    std::shared_ptr<const Scene> m_scene;
    Tracer m_tracer;
    Vec3f m_centre;
};

}  // namespace burnish
