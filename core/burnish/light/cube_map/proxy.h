// What stands for the room around a cube map: where a ray from a shaded point ends, and what the map saw there.
//
// A cube map knows the room from its centre c only. A ray from p along d that meets the proxy at x shows what the map has in
// direction x - c. Every proxy has
//
//     void ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const;   out: cleared, then in the order of the rays
//
// Rays from c itself end where the map says, whatever the proxy: the same point, met from two places.
#pragma once

#include <burnish/light/cube_map/bounding_planes.h>
#include <burnish/light/cube_map/depth_impostor.h>
#include <burnish/light/cube_map/proxy_mesh.h>
#include <burnish/light/cube_map/ray_end.h>

#include <variant>

namespace burnish {

/// Nothing near: rays are looked up by direction alone.
class InfiniteProxy {
public:
    void ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const {
        out.clear();
        for (uint32_t i = 0; i < rays.size(); ++i) out.push_back(RayEnd::nowhere(i, rays[i].d));
    }
};

using Proxy = std::variant<InfiniteProxy, BoundingPlanes, DepthImpostor, ProxyMesh>;

}  // namespace burnish
