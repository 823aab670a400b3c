#include <burnish/light/traced/lamps.h>

#include <burnish/base/parallel.h>
#include <burnish/sampling/sequence.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr uint32_t kPoints = 32;
constexpr float kBright = 3;       // times the scene's mean radiance
constexpr int kMostSteps = 6;      // of the grid over a triangle on which its light is averaged
constexpr float kPastHit = 1e-5f;  // of its distance: where to look for what lies behind a hit

struct Triangle {
    Vertex a, b, c;
    Hit hit;  // object, triangle and front
    double area = 0, power = 0;
};

Vertex between(const Vertex& a, const Vertex& b, const Vertex& c, const Vec2f& at) {
    const float w = 1 - at.x - at.y;
    return {a.p * w + b.p * at.x + c.p * at.y, a.n, a.t, a.uv * w + b.uv * at.x + c.uv * at.y};
}

/// Centre of one of the steps^2 equal parts of a triangle, barycentric: those that point up, then those that point down.
Vec2f centre_of_part(int i, int j, int steps) {
    const bool up = i + j < steps;
    const float third = up ? 1.0f / 3 : 2.0f / 3;
    return Vec2f(static_cast<float>(up ? i : steps - 1 - i) + third, static_cast<float>(up ? j : steps - 1 - j) + third) /
           static_cast<float>(steps);
}

/// Luminance that leaves the front, on average, times the area.
double power_of(const SurfaceLight& light, Triangle& triangle) {
    const float width = std::sqrt(static_cast<float>(triangle.area)), widest = light.widest(triangle.hit);
    const int steps = widest > 0 ? static_cast<int>(std::clamp(std::ceil(width / widest), 1.0f, float{kMostSteps})) : 1;
    double sum = 0;
    for (int part = 0; part < steps * steps; ++part) {
        const Vec2f at = centre_of_part(part / steps, part % steps, steps);
        triangle.hit.uv = between(triangle.a, triangle.b, triangle.c, at).uv;
        sum += luminance(light.radiance(triangle.hit, width / static_cast<float>(steps)));
    }
    return triangle.area * sum / (steps * steps);
}

std::vector<Triangle> triangles_of(const Scene& scene) {
    std::vector<Triangle> triangles;
    for (size_t object = 0; object < scene.objects.size(); ++object) {
        const Mesh& mesh = scene.objects[object].mesh;
        for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& [a, b, c] = mesh.triangles[i];
            Triangle triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], {}};
            triangle.area = 0.5 * (triangle.b.p - triangle.a.p).cross(triangle.c.p - triangle.a.p).length();
            triangle.hit.object = static_cast<int>(object), triangle.hit.triangle = i;
            if (triangle.area > 0) triangles.push_back(triangle);
        }
    }
    return triangles;
}

/// Those that are bright, with their power.
std::vector<Triangle> bright_triangles(const SurfaceLight& light) {
    std::vector<Triangle> triangles = triangles_of(light.scene());
    for_each_index(static_cast<int>(triangles.size()), [&](int i) { triangles[i].power = power_of(light, triangles[i]); });
    double area = 0, power = 0;
    for (const Triangle& triangle : triangles) area += triangle.area, power += triangle.power;
    std::erase_if(triangles, [&](const Triangle& t) { return !(t.power * area > kBright * power * t.area); });
    return triangles;
}

}  // namespace

Lamps::Lamps(const SurfaceLight& light) {
    const std::vector<Triangle> triangles = bright_triangles(light);
    if (triangles.empty()) return;
    auto scene = std::make_shared<Scene>();
    Mesh& mesh = scene->objects.emplace_back().mesh;
    std::vector<double> powers;
    for (const Triangle& triangle : triangles) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {triangle.a, triangle.b, triangle.c});
        mesh.triangles.push_back({first, first + 1, first + 2});
        powers.push_back(triangle.power);
    }
    m_table = SampleTable(static_cast<int>(powers.size()), 1, powers);
    m_of_scene.resize(light.scene().objects.size());
    for (size_t i = 0; i < triangles.size(); ++i) {
        const Hit& place = triangles[i].hit;
        m_places.push_back(place);
        m_weights.push_back(static_cast<float>(m_table.probability(static_cast<int>(i), 0) / triangles[i].area));
        std::vector<float>& weights = m_of_scene[static_cast<size_t>(place.object)];
        weights.resize(light.scene().objects[static_cast<size_t>(place.object)].mesh.triangles.size());
        weights[place.triangle] = m_weights.back();
    }
    m_tracer.emplace(*scene);
    m_triangles = std::move(scene);
    make_points(light);
}

void Lamps::make_points(const SurfaceLight& light) {
    const Mesh& mesh = m_triangles->objects[0].mesh;
    for (uint32_t i = 0; i < kPoints; ++i) {
        const Drawn drawn = draw(owen_sobol(i, 0));
        const auto& [a, b, c] = mesh.triangles[drawn.triangle];
        const Vec3f pa = mesh.vertices[a].p;
        Hit hit = m_places[drawn.triangle];
        hit.uv = drawn.uv;
        const float density = kPoints * m_weights[drawn.triangle];
        const Color3f radiance = light.radiance(hit, std::sqrt(4 / (kPi * density)));
        m_points.push_back({drawn.p, (mesh.vertices[b].p - pa).cross(mesh.vertices[c].p - pa).normalized(), radiance, density});
    }
}

float Lamps::density(const Hit& hit) const {
    if (empty() || !hit.front) return 0;
    const std::vector<float>& weights = m_of_scene[static_cast<size_t>(hit.object)];
    return weights.empty() ? 0 : kPoints * weights[hit.triangle];
}

Lamps::Drawn Lamps::draw(const Vec2f& u) const {
    const SampleTable::Place place = m_table.sample(u);
    const Mesh& mesh = m_triangles->objects[0].mesh;
    const auto& [a, b, c] = mesh.triangles[static_cast<size_t>(place.column)];
    const float root = std::sqrt(place.x);
    const Vec2f at(root * (1 - place.y), root * place.y);
    const Vertex vertex = between(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], at);
    return {vertex.p, vertex.uv, static_cast<size_t>(place.column)};
}

LightDraw Lamps::sample(const Vec3f& p, const Vec2f& u) const {
    if (empty()) return {};
    const Vec3f d = (draw(u).p - p).normalized();
    return {d, pdf(p, d)};
}

float Lamps::pdf(const Vec3f& p, const Vec3f& d) const {
    if (empty()) return 0;
    float sum = 0, from = 0;
    while (const auto hit = m_tracer->closest(p, d, from)) {
        const float cosine = std::abs(hit->ng.dot(d)), distance = hit->distance;
        if (hit->front && cosine > 0) sum += m_weights[hit->triangle] * distance * distance / cosine;
        from = distance * (1 + kPastHit);
        if (!(from > distance)) break;
    }
    return sum;
}

}  // namespace burnish
