#include <burnish/input/name_pattern.h>
#include <burnish/scene/find_objects.h>

#include <Imath/ImathBox.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace burnish {
namespace {

/// Planes to a thousandth of a radian and of a scene unit.
using PlaneKey = std::tuple<long, long, long, long>;
PlaneKey key_of(const Vec3f& n, const Vec3f& p) {
    const auto cell = [](float v) { return std::lround(1000 * v); };
    return {cell(n.x), cell(n.y), cell(n.z), cell(n.dot(p))};
}

struct Facet {
    double area = 0;
    HalfSpace plane;
};

}  // namespace

std::vector<int> objects_named(const Scene& scene, const std::string& patterns) {
    const std::vector<NamePattern> names = name_patterns(patterns);
    std::vector<int> found;
    for (size_t i = 0; i < scene.objects.size(); ++i)
        if (std::ranges::any_of(names, [&](const NamePattern& name) { return name.matches(scene.objects[i].name); }))
            found.push_back(static_cast<int>(i));
    return found;
}

Vec3f bounding_centre(const Scene& scene, const std::vector<int>& objects) {
    Imath::Box<Vec3f> box;
    for (const int i : objects)
        for (const Vertex& vertex : scene.objects[static_cast<size_t>(i)].mesh.vertices) box.extendBy(vertex.p);
    return box.center();
}

std::optional<HalfSpace> largest_plane(const Scene& scene, const std::vector<int>& objects, const Vec3f& eye) {
    std::map<PlaneKey, Facet> facets;
    for (const int i : objects) {
        const Mesh& mesh = scene.objects[static_cast<size_t>(i)].mesh;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3f &p = mesh.vertices[a].p, cross = (mesh.vertices[b].p - p).cross(mesh.vertices[c].p - p);
            const Vec3f n = cross.normalized();
            if (n.dot(eye - p) <= 0) continue;
            Facet& facet = facets[key_of(n, p)];
            if (facet.area == 0) facet.plane = {p, n};
            facet.area += 0.5 * cross.length();
        }
    }
    const auto largest = std::ranges::max_element(facets, {}, [](const auto& facet) { return facet.second.area; });
    if (largest == facets.end()) return std::nullopt;
    return largest->second.plane;
}

}  // namespace burnish
