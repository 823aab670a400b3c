#include <burnish/shading/area_shading.h>

#include <burnish/material/lobe.h>
#include <burnish/light/focused_nodes.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/shading_point.h>
#include <burnish/shading/tap.h>

#include <algorithm>

namespace burnish {
float kFine = 0.6f, kCoarse = 1.2f;
bool kFocus = true;
float kFineQ = 0.4f, kCoarseQ = 0.8f;
namespace {

const Matrix33f kWorld;           // lights know their own axes
constexpr float kFlattest = 0.02f;
constexpr float kLowest = 0.05f;  // cosine: lower nodes count as there when their spread is measured
constexpr float kWidened = 2;     // lobe whose values bound the derivatives of this one

/// A tap's Gaussian.
struct TapKernel {
    Vec3f d;
    float sharpness;
    Color3f peak;

    TapKernel(const LightRay& ray, const Color3f& weight)
        : d(ray.d),
          sharpness(1 / (ray.sigma * ray.sigma)),
          peak(weight * (sharpness / (2 * kPi * -std::expm1(-2 * sharpness)))) {}
    Color3f at(const Vec3f& wi) const { return peak * std::exp(-0.5f * sharpness * (wi - d).length2()); }
};

/// A node as seen from the point.
struct SeenNode {
    Vec3f towards, wi;      // world; local
    float distance, angle;  // angle: radius of the part it stands for
    Color3f sent;           // radiance times solid angle
};

/// 1 up to `from`, 0 from `to` on.
float fade(float x, float from, float to) {
    const float t = std::clamp((to - x) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// One lamp, seen from one point after the other.
class DirectLamp {
public:
    DirectLamp(const AreaLight& lamp, const LightChain& lights, size_t link) : m_lamp(lamp), m_lights(lights), m_link(link) {}

    /// Adds to `sum`; returns what is kept of the taps.
    template <class LobeType>
    float add(const LobeType& lobe, const ShadingPoint& point, const LightRay& at, std::span<const LightRay> rays,
              std::span<const Color3f> weights, bool long_tailed, DirectLight& sum) {
        const bool focused = kFocus && long_tailed && m_lamp.is_solid();
        if (focused) focus(lobe, point, at); else
        look_from(point, at);
        if (m_nodes.empty()) return 1;
        const float spread = focused ? 0 : spread_over(lobe, point), w = fade(spread, kFine, kCoarse),
                    kept = 1 - fade(spread, kFineQ, kCoarseQ);
        if (!(w > 0)) return 1;
        m_kernels.clear();
        if (kept > 0)
            for (size_t k = 0; k < rays.size(); ++k) m_kernels.emplace_back(rays[k], weights[k] * kept);
        const auto wide = lobe.with_widths(kWidened * point.mx, kWidened * point.my);
        for (const SeenNode& node : m_nodes) {
            const float left = w * m_lights.left_for(m_link, {at.p, at.ng, node.towards, node.angle, lobe.side_sign});
            const Color3f reflected = value(lobe, point, node), sent = node.sent * left;
            Color3f missing = reflected;
            for (const TapKernel& tap : m_kernels) missing -= tap.at(node.towards);
            sum.radiance += missing * sent;
            sum.nearness += std::fabs(luminance(reflected * sent)) / node.distance;
            sum.bend += std::fabs(luminance(value(wide, point, node) * sent)) * kWidened * kWidened / (2 * point.mx * point.my);
        }
        sum.nodes += static_cast<float>(m_nodes.size());
        return kept;
    }

private:
    template <class LobeType>
    static Color3f value(const LobeType& lobe, const ShadingPoint& point, const SeenNode& node) {
        const float cosine = node.wi.z * lobe.side_sign, above = point.ng.dot(node.wi) * lobe.side_sign;
        if (cosine <= 0) return Color3f(0);
        return lobe.eval(point.wo, node.wi) * point.scale *
               (cosine * visible_share(cosine, above, 1 / std::max(node.angle, 1e-4f)));
    }

    void look_from(const ShadingPoint& point, const LightRay& at) {
        m_nodes.clear();
        const float height = m_lamp.polygon().height(at.p);
        if (!(height > 0) && !(m_lamp.is_two_sided() && height < 0)) return;
        see(m_lamp.nodes_above(at.p, at.ng * at.side, m_cut), point, at, height);
    }

    void see(std::span<const AreaNode> nodes, const ShadingPoint& point, const LightRay& at, float height) {
        for (const AreaNode& node : nodes) {
            const Vec3f way = node.p - at.p;
            const float distance = way.length();
            const Vec3f towards = way / distance;
            m_nodes.push_back({towards, point.frame.to_local(towards), distance, node.radius / distance,
                               node.power * (std::fabs(height) / (distance * distance * distance))});
        }
    }

    /// Nodes for a lobe with a long tail.
    template <class LobeType>
    void focus(const LobeType& lobe, const ShadingPoint& point, const LightRay& at) {
        m_nodes.clear();
        const ConvexPolygon& polygon = m_lamp.polygon();
        const float height = polygon.height(at.p);
        if (!(height > 0) && !(m_lamp.is_two_sided() && height < 0)) return;
        polygon.above(at.p, at.ng * at.side, m_corners);
        if (m_corners.empty()) return;
        const Vec3f mirrored(-point.wo.x, -point.wo.y, point.wo.z * lobe.side_sign), peak = point.frame.to_world(mirrored);
        const Vec3f foot = at.p - polygon.normal * height;
        const float towards = -polygon.normal.dot(peak) * std::copysign(1.0f, height);
        const Vec3f aside = peak - polygon.normal * polygon.normal.dot(peak);
        const Vec3f centre = nearest_place(foot + aside * (std::fabs(height) / std::max(towards, kFlattest)));
        PlaneQuadratic q;
        q.origin = centre, q.axis_y = polygon.longest_edge(), q.axis_x = q.axis_y.cross(polygon.normal);
        const float step = 1e-2f * (centre - at.p).length();
        const auto slopes = [&](const Vec3f& place) {
            Vec3f wi = lobe.mirrored(point.frame.to_local((place - at.p).normalized()));
            wi.z = std::max(wi.z, kLowest);
            const Vec2f s = half_slopes(point.wo, wi);
            return Vec2f(s.x / point.mx, s.y / point.my);
        };
        const Vec2f s = slopes(centre), sx = (slopes(centre + q.axis_x * step) - slopes(centre - q.axis_x * step)) / (2 * step), sy = (slopes(centre + q.axis_y * step) - slopes(centre - q.axis_y * step)) / (2 * step);
        const Vec3f off = centre - foot;
        const float per_height = 1 / (height * height + off.length2());  // 1 + Q of the distance is r^2 / its value at the centre
        q.xx = sx.dot(sx) + per_height, q.yy = sy.dot(sy) + per_height, q.xy = sx.dot(sy);
        q.bx = s.dot(sx) + off.dot(q.axis_x) * per_height, q.by = s.dot(sy) + off.dot(q.axis_y) * per_height, q.at_origin = s.length2();
        m_cut.clear();
        add_focused_nodes(m_corners, m_lamp.radiance(), q, m_cut);
        see(m_cut, point, at, height);
    }

    /// The place of the lamp, as far as it is above the horizon, that is nearest to a place on its plane.
    Vec3f nearest_place(const Vec3f& place) const {
        Vec3f best = place;
        float least = INFINITY;
        bool inside = true;
        for (size_t i = 0; i < m_corners.size(); ++i) {
            const Vec3f &a = m_corners[i], way = m_corners[(i + 1) % m_corners.size()] - a;
            inside = inside && m_lamp.polygon().normal.dot(way.cross(place - a)) >= 0;
            const Vec3f on = a + way * std::clamp(way.dot(place - a) / std::max(way.length2(), 1e-20f), 0.0f, 1.0f);
            if ((place - on).length2() < least) least = (place - on).length2(), best = on;
        }
        return inside ? place : best;
    }

    /// How far the nodes spread in slopes of the half vector, in the lobe's widths, over the lobe's own scale there, which grows with
    /// the distance from its peak.
    template <class LobeType>
    float spread_over(const LobeType& lobe, const ShadingPoint& point) const {
        Vec2f mean(0, 0);
        float square = 0, nearest = INFINITY;
        for (const SeenNode& node : m_nodes) {
            Vec3f wi = lobe.mirrored(node.wi);
            wi.z = std::max(wi.z, kLowest);
            Vec2f slope = half_slopes(point.wo, wi);
            slope.x /= point.mx, slope.y /= point.my;
            mean += slope, square += slope.length2(), nearest = std::min(nearest, slope.length2());
        }
        const float count = static_cast<float>(m_nodes.size());
        return std::sqrt(std::max(square / count - (mean / count).length2(), 0.0f) / (1 + nearest));
    }

    const AreaLight& m_lamp;
    const LightChain& m_lights;
    size_t m_link;
    std::vector<AreaNode> m_cut;
    std::vector<Vec3f> m_corners;
    std::vector<SeenNode> m_nodes;
    std::vector<TapKernel> m_kernels;
};

}  // namespace

std::vector<DirectLight> direct_light(const LobeParameters& parameters, const LightChain& lights, const SurfaceBatch& batch,
                                      const TapRaysView& taps, std::vector<float>& kept) {
    std::vector<DirectLight> out;
    kept.clear();
    for (size_t link = 0; link < lights.links().size(); ++link) {
        const auto* lamp = std::get_if<AreaLight>(lights.links()[link].light.get());
        if (!lamp) continue;
        out.resize(batch.size()), kept.resize(lights.links().size() * taps.rays.size(), 1.0f);
        DirectLamp direct(*lamp, lights, link);
        visit_lobe(parameters, [&](const auto& prototype) {
            const bool long_tailed = lobe_tail([&](float xi) { return prototype.border(xi); }) != LobeTail::gaussian;
            for (size_t i = 0, begin = 0; i < batch.size(); begin = taps.ends[i++]) {
                const ShadingPoint point = shading_point(batch, i, parameters, kWorld);
                const auto lobe = prototype.with_widths(point.mx, point.my);
                const size_t count = taps.ends[i] - begin;
                const LightRay at{batch.p[i], batch.geometric_normal()[i], {}, 0, lobe.side_sign};
                const float share =
                    direct.add(lobe, point, at, taps.rays.subspan(begin, count), taps.weights.subspan(begin, count), long_tailed, out[i]);
                std::fill_n(kept.begin() + static_cast<std::ptrdiff_t>(link * taps.rays.size() + begin), count, share);
            }
        });
    }
    return out;
}

}  // namespace burnish
