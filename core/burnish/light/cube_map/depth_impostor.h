// A cube map's own distances as the room around it: rays are followed across the map until they pass behind what it saw.
//
// Seen from the centre a ray is an arc of directions. Along it w (distance_map.h) goes from below 1 (the ray is in front of what
// the map saw) to above 1 (behind it) where it meets a surface; the place is then found by the secant, which is exact on flat walls.
// Arcs well in front of everything are skipped by blocks. Where the map's surface breaks off, at the outline of something near,
// rays may pass behind it, where the map saw nothing: they go on until they come to light again and meet a surface. Those that
// never do end at the outline, as far away as what is seen beside it. A point that is hidden from the centre is treated alike; if its
// ray stays hidden all along, it is looked up by direction alone.
// Source: Szirmay-Kalos et al. 2005, "Approximate Ray-Tracing on the GPU with Distance Impostors"; the march is not theirs.
#pragma once

#include <burnish/light/cube_map/distance_map.h>
#include <burnish/light/cube_map/ray_end.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burnish {

class DepthImpostor {
public:
    DepthImpostor(std::shared_ptr<const DistanceMap> distances, const Vec3f& centre)
        : m_distances(std::move(distances)), m_centre(centre) {}

    void ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const;

private:
    std::shared_ptr<const DistanceMap> m_distances;
    Vec3f m_centre;
};

}  // namespace burnish
