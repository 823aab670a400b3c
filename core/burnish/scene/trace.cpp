#include <burnish/base/error.h>
#include <burnish/scene/trace.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace burnish {
namespace {

#if RTC_VERSION_MAJOR >= 4
constexpr RTCSceneFlags kFilterPerRay = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
using QueryContext = RTCRayQueryContext;
#else
constexpr RTCSceneFlags kFilterPerRay = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
using QueryContext = RTCIntersectContext;
#endif

}  // namespace

struct Tracer::Embree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Embree() {
        device = rtcNewDevice(nullptr);
        if (!device) throw Error(ErrorCode::bad_argument, "Embree could not start on this processor");
        scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | kFilterPerRay);  // robust: no leaks through shared edges
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

namespace {

void check_triangles(const Object& object) {
    for (const auto& triangle : object.mesh.triangles)
        for (const uint32_t i : triangle)
            if (i >= object.mesh.vertices.size())
                throw Error(ErrorCode::bad_argument, "object '" + object.name + "': a triangle names vertex " +
                                                         std::to_string(i) + ", but the mesh has " +
                                                         std::to_string(object.mesh.vertices.size()));
}

/// Embree copies positions and triangles into its own, padded buffers.
void attach(RTCDevice device, RTCScene scene, const Mesh& mesh, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* p = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.vertices.size()));
    auto* triangles = static_cast<std::array<uint32_t, 3>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uint32_t) * 3, mesh.triangles.size()));
    std::ranges::transform(mesh.vertices, p, &Vertex::p);
    std::ranges::copy(mesh.triangles, triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

RTCRay make_ray(const Vec3f& origin, const Vec3f& direction, float near, float far) {
    RTCRay ray{};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = near, ray.tfar = far, ray.mask = ~0u;
    return ray;
}

/// What Embree hands to a filter, with the objects that a ray does not see.
struct Query : QueryContext {
    std::span<const int> hidden;
};

/// Refuses hits of hidden objects; rays come one by one.
void pass_through(const RTCFilterFunctionNArguments* hit) {
    const auto object = static_cast<int>(RTCHitN_geomID(hit->hit, hit->N, 0));
    const auto& hidden = static_cast<const Query*>(hit->context)->hidden;
    if (std::ranges::find(hidden, object) != hidden.end()) hit->valid[0] = 0;
}

#if RTC_VERSION_MAJOR >= 4
template <class Arguments>
void prepare(Query& query, Arguments& arguments) {
    rtcInitRayQueryContext(&query);
    arguments.context = &query;
    if (!query.hidden.empty()) arguments.filter = pass_through, arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
}
void intersect(RTCScene scene, RTCRayHit& ray, Query query) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    prepare(query, arguments);
    rtcIntersect1(scene, &ray, &arguments);
}
void test_occlusion(RTCScene scene, RTCRay& ray, Query query) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    prepare(query, arguments);
    rtcOccluded1(scene, &ray, &arguments);
}
#else
void prepare(Query& query) {
    rtcInitIntersectContext(&query);
    if (!query.hidden.empty()) query.filter = pass_through;
}
void intersect(RTCScene scene, RTCRayHit& ray, Query query) {
    prepare(query);
    rtcIntersect1(scene, &query, &ray);
}
void test_occlusion(RTCScene scene, RTCRay& ray, Query query) {
    prepare(query);
    rtcOccluded1(scene, &query, &ray);
}
#endif

}  // namespace

Tracer::Tracer(const Scene& scene) : m_scene(&scene) {
    auto embree = std::make_shared<Embree>();
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        check_triangles(scene.objects[i]);
        attach(embree->device, embree->scene, scene.objects[i].mesh, static_cast<unsigned>(i));
    }
    // Built by one thread: the order of a tree's leaves, which decides hits on shared edges, must not depend on their number.
    tbb::task_arena(1).execute([&] { rtcJoinCommitScene(embree->scene); });
    m_embree = embree;
}

std::optional<Hit> Tracer::closest(const Vec3f& origin, const Vec3f& direction, float near, float far,
                                   std::span<const int> hidden) const {
    RTCRayHit query{};
    query.ray = make_ray(origin, direction, near, far);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(m_embree->scene, query, Query{{}, hidden});
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Mesh& mesh = m_scene->objects[query.hit.geomID].mesh;
    const auto& [i, j, k] = mesh.triangles[query.hit.primID];
    const Vertex &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const float u = query.hit.u, v = query.hit.v, w = 1 - u - v;
    Hit hit;
    hit.distance = query.ray.tfar;
    hit.object = static_cast<int>(query.hit.geomID);
    hit.triangle = query.hit.primID;
    hit.p = a.p * w + b.p * u + c.p * v;
    hit.ng = (b.p - a.p).cross(c.p - a.p).normalized();
    hit.n = (a.n * w + b.n * u + c.n * v).normalized();
    hit.uv = a.uv * w + b.uv * u + c.uv * v;
    hit.front = hit.ng.dot(direction) <= 0;
    if (!hit.front) hit.ng = -hit.ng, hit.n = -hit.n;
    hit.t = Frame::along(hit.n, a.t * w + b.t * u + c.t * v).t;
    return hit;
}

bool Tracer::occluded(const Vec3f& origin, const Vec3f& direction, float distance, std::span<const int> hidden) const {
    RTCRay ray = make_ray(origin, direction, 0, distance);
    test_occlusion(m_embree->scene, ray, Query{{}, hidden});
    return ray.tfar < 0;
}

Vec3f leaving_point(const Hit& hit) {
    const float size = std::max({std::abs(hit.p.x), std::abs(hit.p.y), std::abs(hit.p.z), 1.0f});
    return hit.p + hit.ng * (1e-4f * size);
}

}  // namespace burnish
