#include <burnish/surface/screen_curvature.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

Vec3f vec3(const Image& image, size_t pixel) {
    const float* v = image.at(pixel);
    return {v[0], v[1], v[2]};
}

/// A vector of a layer at a pixel, made unit if asked for.
Vec3f value(const Image& layer, bool unit, size_t pixel) {
    const Vec3f v = vec3(layer, pixel);
    return unit ? v / std::sqrt(v.length2()) : v;
}

}  // namespace

ScreenCurvature::ScreenCurvature(const AovFrame& frame, const Assignment& assignment, const Surfaces& surfaces)
    : m_surfaces(surfaces),
      m_assignment(assignment),
      m_camera(*frame.camera),
      m_position(frame.layer(Role::position)),
      m_normal(frame.layer(Role::normal)),
      m_object_id(frame.find(Role::object_id)),
      m_material_id(frame.find(Role::material_id)),
      m_forward(m_camera.forward()),
      m_right(m_camera.right * (2.0f / frame.display_window.width)),
      m_down(m_camera.up * (-2.0f / frame.display_window.height)),
      m_pixel_angle(m_camera.has_rays ? std::max(m_right.length(), m_down.length()) : angle_of_positions()) {}

/// The median over neighbours, every seventh pixel: a few edges, and positions rounded to halves, do not move it far.
float ScreenCurvature::angle_of_positions() const {
    constexpr size_t kStep = 7;
    std::vector<float> across, down;
    const size_t width = m_position.width, end = m_position.pixel_count() - width;
    const auto is_valid = [&](size_t pixel) { return m_surfaces.validity(pixel) == Validity::valid; };
    for (size_t pixel = 0; pixel < end; pixel += kStep) {
        if (!is_valid(pixel) || pixel % width + 1 == width) continue;
        const Vec3f wo = seen(pixel).wo;
        if (is_valid(pixel + 1)) across.push_back((seen(pixel + 1).wo - wo).length());
        if (is_valid(pixel + width)) down.push_back((seen(pixel + width).wo - wo).length());
    }
    float angle = 0;
    for (std::vector<float>* list : {&across, &down}) {
        if (list->empty()) continue;
        std::nth_element(list->begin(), list->begin() + list->size() / 2, list->end());
        angle = std::max(angle, (*list)[list->size() / 2]);
    }
    return angle;
}

ScreenCurvature::Seen ScreenCurvature::seen(size_t pixel) const {
    Seen s{vec3(m_position, pixel), value(m_normal, true, pixel), {}, 0};
    const Vec3f to_eye = m_camera.centre - s.p;
    s.distance = std::sqrt(to_eye.length2());
    s.wo = to_eye / s.distance;
    return s;
}

/// No edge between two neighbours: same ids and material, and no more depth between them than the steeper of both slopes makes.
bool ScreenCurvature::same_surface(size_t a, const Seen& at_a, size_t b) const {
    constexpr float kSlack = 4;
    if (m_surfaces.validity(b) != Validity::valid || m_assignment.rule[a] != m_assignment.rule[b]) return false;
    for (const Image* ids : {m_object_id, m_material_id})
        if (ids && *ids->at(a) != *ids->at(b)) return false;
    const float cos_a = at_a.n.dot(at_a.wo), cos_b = value(m_normal, true, b).dot(at_a.wo);
    const float depth = std::fabs((vec3(m_position, b) - at_a.p).dot(at_a.wo)), step = m_pixel_angle * at_a.distance;
    return depth * std::max(std::min(cos_a, cos_b), 0.05f) < kSlack * step;
}

ScreenCurvature::Neighbours ScreenCurvature::neighbours(size_t pixel, const Seen& here) const {
    Neighbours around{};
    const int width = m_position.width, px = static_cast<int>(pixel % width), py = static_cast<int>(pixel / width);
    for (int y = std::max(py - 1, 0); y <= std::min(py + 1, m_position.height - 1); ++y)
        for (int x = std::max(px - 1, 0); x <= std::min(px + 1, width - 1); ++x) {
            const size_t other = static_cast<size_t>(y) * width + x;
            around[y - py + 1][x - px + 1] = other == pixel || same_surface(pixel, here, other);
        }
    return around;
}

/// Differences along each line of the 3 x 3 pixels, central where both ends are there; the middle line counts twice.
ScreenCurvature::Change ScreenCurvature::change_of(const Image& layer, bool unit, size_t pixel,
                                                   const Neighbours& around) const {
    Vec3f values[3][3];
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            if (around[y][x]) values[y][x] = value(layer, unit, pixel + (y - 1) * static_cast<long>(layer.width) + (x - 1));
    const auto mean = [&](const auto& at, const auto& is_there) {
        Vec3f sum(0, 0, 0);
        float weights = 0;
        for (int line = 0; line < 3; ++line) {
            const int first = is_there(line, 0) ? 0 : 1, last = is_there(line, 2) ? 2 : 1;
            if (first == last || !(is_there(line, first) && is_there(line, last))) continue;
            const float weight = line == 1 ? 2.0f : 1.0f;
            sum += (at(line, last) - at(line, first)) * (weight / static_cast<float>(last - first)), weights += weight;
        }
        return weights > 0 ? sum / weights : sum;
    };
    return {mean([&](int y, int x) { return values[y][x]; }, [&](int y, int x) { return around[y][x]; }),
            mean([&](int x, int y) { return values[y][x]; }, [&](int x, int y) { return around[y][x]; })};
}

/// dP^T dP: the pixel's cone across the ray, and what its slope adds along it.
ScreenCurvature::Form ScreenCurvature::footprint(size_t pixel, const Seen& here, const Neighbours& around) const {
    const float step = m_pixel_angle * here.distance, across = step * step;
    Vec2f slope;  // distance gained per pixel
    if (m_camera.has_rays) {
        constexpr float kLeastCosine = 1e-3f;
        const float cos_o = here.n.dot(here.wo), depth = -here.distance * here.wo.dot(m_forward);
        const Vec3f tilt = (here.n - here.wo * cos_o) * (depth / std::max(cos_o, kLeastCosine));
        slope = {m_right.dot(tilt), m_down.dot(tilt)};
    } else {
        const Change p = change_of(m_position, false, pixel, around);
        slope = {p.x.dot(here.wo), p.y.dot(here.wo)};
    }
    return {across + slope.x * slope.x, slope.x * slope.y, across + slope.y * slope.y};
}

float ScreenCurvature::at(size_t pixel) const {
    if (m_surfaces.validity(pixel) != Validity::valid || !(m_pixel_angle > 0)) return 0;
    const Seen here = seen(pixel);
    const Neighbours around = neighbours(pixel, here);
    const Change n = change_of(m_normal, true, pixel, around);
    const Form P = footprint(pixel, here, around), N{n.x.dot(n.x), n.x.dot(n.y), n.y.dot(n.y)};
    const float det_P = P.xx * P.yy - P.xy * P.xy, det_N = std::max(N.xx * N.yy - N.xy * N.xy, 0.0f);
    const float half = 0.5f * (N.xx * P.yy + N.yy * P.xx - 2 * N.xy * P.xy);
    return std::sqrt((half + std::sqrt(std::max(half * half - det_N * det_P, 0.0f))) / det_P);
}

Image screen_curvature(const ScreenCurvature& curvature, int width, int height) {
    Image image(width, height, 1);
    for_each_index(height, [&](int y) {
        for (int x = 0; x < width; ++x) *image.at(x, y) = curvature.at(static_cast<size_t>(y) * width + x);
    });
    return image;
}

}  // namespace burnish
