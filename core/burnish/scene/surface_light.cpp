#include <burnish/scene/surface_light.h>

#include <burnish/base/error.h>
#include <burnish/scene/map_pyramid.h>

#include <algorithm>

namespace burnish {
namespace {

const Image& checked(const Image& map, const std::string& what) {
    if (!map.empty() && map.channels != 3)
        throw Error(ErrorCode::bad_argument, what + " map has " + std::to_string(map.channels) + " channels, expected 3");
    return map;
}

/// Length of texture coordinates per scene unit on a triangle, as the geometric mean over directions; 0 where it has none.
float uv_per_unit(const Object& object, uint32_t triangle) {
    const auto& [i, j, k] = object.mesh.triangles[triangle];
    const Vertex &a = object.mesh.vertices[i], &b = object.mesh.vertices[j], &c = object.mesh.vertices[k];
    const float area = (b.p - a.p).cross(c.p - a.p).length(), uv_area = std::abs((b.uv - a.uv).cross(c.uv - a.uv));
    return area > 0 ? std::sqrt(uv_area / area) : 0.0f;
}

/// Texels of a map per scene unit.
float density(const MapPyramid& map, const Scene& scene, const Hit& hit) {
    return map.resolution() * uv_per_unit(scene.objects[static_cast<size_t>(hit.object)], hit.triangle);
}

Color3f read(const MapPyramid& map, const Scene& scene, const Hit& hit, float diameter) {
    return map.at(hit.uv, diameter > 0 ? diameter * density(map, scene, hit) : 0.0f);
}

Color3f above_zero(const Color3f& c) { return {std::max(c.x, 0.0f), std::max(c.y, 0.0f), std::max(c.z, 0.0f)}; }

}  // namespace

struct SurfaceLight::Pyramids {
    MapPyramid radiance, irradiance, albedo;
};

SurfaceLight::SurfaceLight(const Scene& scene, LightMaps maps) : m_scene(&scene) {
    checked(maps.radiance, "radiance"), checked(maps.irradiance, "irradiance"), checked(maps.albedo, "albedo");
    const int largest = std::max({maps.radiance.width, maps.irradiance.width, maps.albedo.width, 1});
    const auto pyramid = [&](Image& map) {
        const float smaller = std::log2(static_cast<float>(largest) / static_cast<float>(std::max(map.width, 1)));
        return MapPyramid(std::move(map), maps.halvings - static_cast<int>(std::lround(smaller)));
    };
    m_pyramids = std::make_shared<Pyramids>(Pyramids{pyramid(maps.radiance), pyramid(maps.irradiance), pyramid(maps.albedo)});
}

Color3f SurfaceLight::radiance(const Hit& hit, float diameter) const {
    const Color3f& emission = m_scene->objects[static_cast<size_t>(hit.object)].emission;
    if (!m_pyramids->radiance.empty()) {
        const Color3f value = read(m_pyramids->radiance, *m_scene, hit, diameter);
        return hit.front ? value : above_zero(value - emission);
    }
    const Color3f reflected = albedo(hit, diameter) * irradiance(hit, diameter);
    return hit.front ? reflected + emission : reflected;
}

Color3f SurfaceLight::irradiance(const Hit& hit, float diameter) const {
    if (m_pyramids->irradiance.empty()) return Color3f(0.0f);
    return read(m_pyramids->irradiance, *m_scene, hit, diameter);
}

Color3f SurfaceLight::albedo(const Hit& hit, float diameter) const {
    if (m_pyramids->albedo.empty()) return m_scene->objects[static_cast<size_t>(hit.object)].albedo;
    return read(m_pyramids->albedo, *m_scene, hit, diameter);
}

float SurfaceLight::widest(const Hit& hit) const {
    const MapPyramid& map = m_pyramids->radiance.empty() ? m_pyramids->irradiance : m_pyramids->radiance;
    const float texels = density(map, *m_scene, hit);
    return texels > 0 ? map.widest() / texels : 0.0f;
}

}  // namespace burnish
