#include <burnish/light/area/area_light.h>

#include <burnish/base/error.h>
#include <burnish/light/clean_picture.h>
#include <burnish/light/picture_reader.h>
#include <burnish/sampling/spherical_triangle.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kSmallest = 1e-6f;  // steradian: smaller lamps are drawn from by area
constexpr float kFlattest = 1e-3f;  // cosine: footprints of flatter rays are as long as that one's
constexpr float kBelowOne = 0x1.fffffep-1f;

[[noreturn]] void refuse(const std::string& problem) { throw Error(ErrorCode::bad_argument, "area light, " + problem); }

bool is_radiance(const Color3f& c) { return is_finite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0; }

/// The triangles from the first corner, as seen from a point.
std::vector<SphericalTriangle> triangles_seen(const ConvexPolygon& polygon, const Vec3f& p) {
    const auto towards = [&](size_t i) { return (polygon.corners[i] - p).normalized(); };
    std::vector<SphericalTriangle> triangles;
    for (size_t i = 1; i + 1 < polygon.corners.size(); ++i) triangles.emplace_back(towards(0), towards(i), towards(i + 1));
    return triangles;
}

double total(const std::vector<SphericalTriangle>& triangles) {
    double sum = 0;
    for (const SphericalTriangle& triangle : triangles) sum += triangle.solid_angle();
    return sum;
}

/// One of the triangles by its share of the solid angle, and a direction in it.
Vec3f sample_seen(const std::vector<SphericalTriangle>& triangles, double solid_angle, const Vec2f& u) {
    double place = static_cast<double>(u.x) * solid_angle;
    size_t chosen = 0;
    while (chosen + 1 < triangles.size() && place >= triangles[chosen].solid_angle())
        place -= triangles[chosen++].solid_angle();
    const double share = place / std::max(triangles[chosen].solid_angle(), 1e-30);
    return triangles[chosen].sample({std::min(static_cast<float>(share), kBelowOne), u.y});
}

/// Uniform over the area.
Vec3f sample_area(const ConvexPolygon& polygon, const Vec2f& u) {
    float place = u.x * polygon.area;
    for (size_t i = 1;; ++i) {
        const Vec3f &a = polygon.corners[0], &b = polygon.corners[i], &c = polygon.corners[i + 1];
        const float area = 0.5f * (b - a).cross(c - a).length();
        if (place >= area && i + 2 < polygon.corners.size()) {
            place -= area;
            continue;
        }
        const float root = std::sqrt(std::clamp(place / area, 0.0f, 1.0f));
        return a + ((b - a) * (1 - u.y) + (c - a) * u.y) * root;
    }
}

}  // namespace

AreaLight::AreaLight(const AreaSettings& settings, const Color3f& gain, Image picture)
    : m_polygon(settings.corners), m_radiance(settings.radiance * gain), m_two_sided(settings.two_sided) {
    if (!is_radiance(m_radiance)) refuse("radiance: expected three finite numbers, none below 0, tint and scale included.");
    if (!picture.empty()) {
        if (!m_polygon.is_parallelogram())
            refuse("texture: a picture needs four corners that make a parallelogram, found " +
                   std::to_string(settings.corners.size()) +
                   " corners that do not. Correct the corners or leave the texture out.");
        const Vec3f u = m_polygon.corners[1] - m_polygon.corners[0], v = m_polygon.corners[3] - m_polygon.corners[0];
        m_picture = std::make_shared<const AreaPicture>(std::move(picture), u.length() / v.length());
        const Vec3f across_v = v.cross(m_polygon.normal), across_u = m_polygon.normal.cross(u);
        m_mean = m_picture->mean();
        m_u = across_v / across_v.dot(u), m_v = across_u / across_u.dot(v);
    }
    m_nodes = area_nodes(m_polygon, m_radiance, m_picture.get());
}

AreaLight AreaLight::load(const AreaSettings& settings, const Color3f& gain, const std::function<void(Image&)>& convert) {
    if (settings.texture.empty()) return AreaLight(settings, gain);
    Image picture = read_picture(settings.texture).pixels;
    std::vector<std::string> warnings;
    clean_picture(picture, convert, settings.texture, warnings);
    return AreaLight(settings, gain, std::move(picture));
}

void AreaLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    SeenPolygon seen;
    const auto up = [&](size_t i) { return rays[i].ng * rays[i].side; };
    for (size_t i = 0; i < rays.size(); ++i) {
        if (i == 0 || rays[i].p != rays[i - 1].p || up(i) != up(i - 1)) seen.look(m_polygon, rays[i].p, up(i), m_two_sided);
        out[i] = incident(rays[i], seen);
    }
}

std::span<const AreaNode> AreaLight::nodes_above(const Vec3f& p, const Vec3f& up, std::vector<AreaNode>& own) const {
    const auto is_above = [&](const Vec3f& corner) { return up.dot(corner - p) >= 0; };
    if (m_picture || std::all_of(m_polygon.corners.begin(), m_polygon.corners.end(), is_above)) return m_nodes;
    std::vector<Vec3f> corners;
    m_polygon.above(p, up, corners);
    own.clear();
    add_area_nodes(corners, m_radiance, own);
    return own;
}

Incident AreaLight::incident(const LightRay& ray, const SeenPolygon& seen) const {
    const GaussianPart part = seen.gaussian(ray.d, ray.sigma);
    if (!(part.reach > 0)) return {};
    const float distance =
        std::fabs(m_polygon.height(ray.p)) / std::max(std::fabs(m_polygon.normal.dot(part.nearest)), kFlattest);
    Incident found{m_radiance * part.share, part.share, luminance(m_radiance) * part.bend, 1 / distance};
    if (!m_picture) return found;
    const AreaPicture::Filtered filtered =
        m_picture->filtered(uv(ray.p + part.nearest * distance), footprint(ray, part.nearest, distance));
    found.radiance *= filtered.mean;
    found.bend = luminance(m_radiance) * filtered.bend * part.reach / std::max(ray.sigma * ray.sigma, 1e-12f);
    return found;
}

/// What the cone's deviations become on the picture: a step across direction w moves its hit by the part of it in the plane
/// that is seen along w.
PictureEllipse AreaLight::footprint(const LightRay& ray, const Vec3f& towards, float distance) const {
    const Frame frame = Frame::around(towards);
    const float along = m_polygon.normal.dot(towards), steep = std::copysign(std::max(std::fabs(along), kFlattest), along);
    const auto moved = [&](const Vec3f& across) {
        const Vec3f step = (across - towards * (m_polygon.normal.dot(across) / steep)) * (distance * ray.sigma);
        return Vec2f(m_u.dot(step), m_v.dot(step));
    };
    return {moved(frame.t), moved(frame.b)};
}

ExactLight AreaLight::exact(const LightRay& ray) const {
    const float height = m_polygon.height(ray.p), towards = m_polygon.normal.dot(ray.d);
    const float distance = -height / towards;
    if (!shines_to(ray.p) || !(distance > 0) || !std::isfinite(distance)) return {};
    const Vec3f place = ray.p + ray.d * distance;
    const size_t count = m_polygon.corners.size();
    for (size_t i = 0; i < count; ++i) {
        const Vec3f& corner = m_polygon.corners[i];
        if (m_polygon.normal.dot((m_polygon.corners[(i + 1) % count] - corner).cross(place - corner)) < 0) return {};
    }
    const Color3f radiance = m_picture ? m_radiance * m_picture->at(uv(place)) : m_radiance;
    return {radiance, 1.0f, pdf(ray.p, ray.d, distance)};
}

/// Of a direction that meets the lamp at that distance.
float AreaLight::pdf(const Vec3f& p, const Vec3f& d, float distance) const {
    const float per_area = distance * distance / std::max(std::fabs(m_polygon.normal.dot(d)), 1e-20f) / m_polygon.area;
    if (m_picture) return per_area * m_picture->pdf(uv(p + d * distance));
    const double solid_angle = total(triangles_seen(m_polygon, p));
    return solid_angle > kSmallest ? static_cast<float>(1 / solid_angle) : per_area;
}

LightDraw AreaLight::sample(const Vec3f& p, const Vec2f& u) const {
    if (!shines_to(p) || m_polygon.height(p) == 0) return {};
    Vec3f place;
    if (m_picture) {
        const Vec2f at = m_picture->sample(u);
        place = m_polygon.corners[0] + (m_polygon.corners[1] - m_polygon.corners[0]) * at.x +
                (m_polygon.corners[3] - m_polygon.corners[0]) * at.y;
    } else {
        const std::vector<SphericalTriangle> triangles = triangles_seen(m_polygon, p);
        const double solid_angle = total(triangles);
        if (solid_angle > kSmallest) return {sample_seen(triangles, solid_angle, u), static_cast<float>(1 / solid_angle)};
        place = sample_area(m_polygon, u);
    }
    const Vec3f way = place - p;
    const float distance = way.length();
    if (!(distance > 0)) return {};
    return {way / distance, pdf(p, way / distance, distance)};
}

}  // namespace burnish
