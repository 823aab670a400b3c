// A room as seen from one point: a cube map whose rays are met by a proxy of the room, so that its picture stays where the room is.
//
// Filtered lookups see the ray's cone from the centre: turned, wider or narrower as the proxy lies to it (ray_end.h). Where the picture's
// alpha is below 1 (windows of a room rendered alone) the light does not cover, and what comes next in the chain shows through.
#pragma once

#include <burnish/light/cube_map/proxy.h>
#include <burnish/light/environment.h>
#include <burnish/light/light_settings.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace burnish {

class CubeMapLight {
public:
    /// Reads the picture, and what the proxy needs. `room`: of the mesh proxy, where it is there already; else its file is read.
    /// `convert`: as Environment::load. Throws Error(read_failed | missing_channel | bad_argument).
    CubeMapLight(const CubeMapSettings& settings, const std::function<void(Image&)>& convert,
                 std::shared_ptr<const Scene> room = nullptr);
    /// From what is there. `cover`: the picture's alpha as a light; empty = 1 everywhere.
    CubeMapLight(Environment picture, std::optional<Environment> cover, const Vec3f& centre, Proxy proxy);

    void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;
    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const { return true; }
    /// The map's bright parts, met from p. Draws that p does not see are lost: their pdf is 0.
    LightDraw sample(const Vec3f& p, const Vec2f& u) const;

    float mean_luminance() const;

    const Environment& picture() const { return m_picture; }
    const Vec3f& centre() const { return m_centre; }

private:
    RayEnd end_of(const LightRay& ray) const;
    float pdf(const LightRay& ray, const RayEnd& end) const;

    Environment m_picture;
    std::optional<Environment> m_cover;
    Vec3f m_centre;
    Proxy m_proxy;
};

}  // namespace burnish
