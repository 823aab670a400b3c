#include <burnish/light/cube_map/proxy_mesh.h>

namespace burnish {

ProxyMesh::ProxyMesh(std::shared_ptr<const Scene> scene, const Vec3f& centre)
    : m_scene(std::move(scene)), m_tracer(*m_scene), m_centre(centre) {}

void ProxyMesh::ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const {
    out.clear();
    for (uint32_t i = 0; i < rays.size(); ++i) {
        const LightRay& ray = rays[i];
        Hit here;
        here.p = ray.p, here.ng = ray.d.dot(ray.ng) < 0 ? -ray.ng : ray.ng;
        const Vec3f origin = leaving_point(here);
        const auto hit = m_tracer.closest(origin, ray.d);
        if (hit)
            out.push_back({i, 1.0f, hit->p - m_centre, hit->ng, std::max((hit->p - ray.p).dot(ray.d), 0.0f)});
        else
            out.push_back(RayEnd::nowhere(i, ray.d));
    }
}

}  // namespace burnish
