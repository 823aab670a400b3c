#include <burnish/shading/area_shading.h>

#include <burnish/material/lobe.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/half_slopes.h>
#include <burnish/shading/lobe_on_lamp.h>
#include <burnish/shading/tap.h>

#include <algorithm>

namespace burnish {
namespace {

const Matrix33f kWorld;  // lights know their own axes

constexpr float kAlone = 0.4f, kNotAlone = 0.8f;           // spread of nodes over the lobe between which q fades
constexpr float kResolved = 0.8f, kUnresolved = 1.6f;      // and w
constexpr float kWidened = 2;                              // lobe whose values bound the derivatives of this one
constexpr int kFocusedOnSolid = 4, kFocusedOnPicture = 3;  // nodes a side

/// 1 up to `from`, 0 from `to` on.
float fade(float x, float from, float to) {
    const float t = std::clamp((to - x) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

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

/// A pixel's lobe, and its taps.
template <class LobeType>
struct PixelLobe {
    const LobeType& lobe;
    const ShadingPoint& point;
    LightRay at;  // p, ng and side
    std::span<const LightRay> rays;
    std::span<const Color3f> weights;
    bool long_tailed;

    Color3f value(const LobeType& own, const SeenNode& node) const {
        const float cosine = node.wi.z * own.side_sign, above = point.ng.dot(node.wi) * own.side_sign;
        if (cosine <= 0) return Color3f(0);
        const float share = visible_share(cosine, above, 1 / std::max(node.angle, 1e-4f));
        return own.eval(point.wo, node.wi) * point.scale * (cosine * share);
    }
};

/// One lamp, seen from one point after the other.
class DirectLamp {
public:
    DirectLamp(const AreaLight& lamp, const LightChain& lights, size_t link) : m_lamp(lamp), m_lights(lights), m_link(link) {}

    /// Adds to `sum`; returns what is kept of the taps.
    template <class LobeType>
    float add(const PixelLobe<LobeType>& pixel, DirectLight& sum) {
        m_height = m_lamp.polygon().height(pixel.at.p);
        if (!(m_height > 0) && !(m_lamp.is_two_sided() && m_height < 0)) return 1;
        if (pixel.long_tailed && m_lamp.is_solid()) {
            look_at_focused(pixel, kFocusedOnSolid);
            add_nodes(pixel, 1, 0, sum);
            return 0;
        }
        look_at_own(pixel);
        if (m_nodes.empty()) return 1;
        const float spread = spread_over(pixel), q = fade(spread, kAlone, kNotAlone), kept = 1 - q;
        if (!pixel.long_tailed) {
            const float w = kept * fade(spread, kResolved, kUnresolved);
            add_nodes(pixel, w + q, w, sum);
            return kept;
        }
        add_nodes(pixel, q, 0, sum);
        if (kept > 0) add_coloured(pixel, kept, sum);
        return 0;
    }

private:
    template <class LobeType>
    void look_at_own(const PixelLobe<LobeType>& pixel) {
        m_nodes.clear();
        for (const AreaNode& node : m_lamp.nodes_above(pixel.at.p, pixel.at.ng * pixel.at.side, m_own)) look_at(pixel, node);
    }

    template <class LobeType>
    void look_at_focused(const PixelLobe<LobeType>& pixel, int side) {
        m_nodes.clear();
        m_lamp.polygon().above(pixel.at.p, pixel.at.ng * pixel.at.side, m_corners);
        if (m_corners.empty()) return;
        const PlaneQuadratic peak = lobe_on_lamp(pixel.point, pixel.at.side, pixel.at.p, m_lamp.polygon(), m_corners);
        focus_nodes(m_corners, peak, side, m_focused);
        for (const FocusedNode& node : m_focused)
            look_at(pixel, {node.p, m_lamp.radiance() * node.area, std::sqrt(node.area / kPi)});
    }

    template <class LobeType>
    void look_at(const PixelLobe<LobeType>& pixel, const AreaNode& node) {
        const Vec3f way = node.p - pixel.at.p;
        const float distance = std::max(way.length(), std::fabs(m_height));
        const Vec3f towards = way / distance;
        m_nodes.push_back({towards, pixel.point.frame.to_local(towards), distance, node.radius / distance,
                           node.power * (std::fabs(m_height) / (distance * distance * distance))});
    }

    /// Adds `share` of the lobe less `taken` of its taps.
    template <class LobeType>
    void add_nodes(const PixelLobe<LobeType>& pixel, float share, float taken, DirectLight& sum) {
        if (!(share > 0)) return;
        m_kernels.clear();
        for (size_t k = 0; taken > 0 && k < pixel.rays.size(); ++k)
            m_kernels.emplace_back(pixel.rays[k], pixel.weights[k] * taken);
        const ShadingPoint& point = pixel.point;
        const auto wide = pixel.lobe.with_widths(kWidened * point.mx, kWidened * point.my);
        for (const SeenNode& node : m_nodes) {
            const LightRay ray{pixel.at.p, pixel.at.ng, node.towards, node.angle, pixel.at.side};
            const Color3f sent = node.sent * m_lights.left_for(m_link, ray);
            const float sharp = kWidened * kWidened / (2 * point.mx * point.my);
            const float bend = std::fabs(luminance(pixel.value(wide, node) * sent)) * share * sharp;
            Color3f missing = pixel.value(pixel.lobe, node) * share;
            sum.bend += bend, sum.nearness += nearness_weight(luminance(missing * sent), bend) / node.distance;
            for (const TapKernel& tap : m_kernels) missing -= tap.at(node.towards);
            sum.radiance += missing * sent;
        }
        sum.nodes += static_cast<float>(m_nodes.size());
    }

    /// Adds `share` of the lobe under a picture: what focused nodes have of an even lamp, in the colour that the taps see; in the
    /// picture's mean, as far as the taps do not see what the nodes do.
    template <class LobeType>
    void add_coloured(const PixelLobe<LobeType>& pixel, float share, DirectLight& sum) {
        look_at_focused(pixel, kFocusedOnPicture);
        DirectLight even;
        add_nodes(pixel, share, 0, even);
        m_found.resize(pixel.rays.size());
        m_lamp.lookup(pixel.rays, m_found);
        Color3f seen(0), coloured(0);
        for (size_t k = 0; k < pixel.rays.size(); ++k) {
            seen += pixel.weights[k] * m_lamp.radiance() * (m_found[k].cover * share);
            coloured += pixel.weights[k] * m_found[k].radiance * share;
        }
        for (int c = 0; c < 3; ++c) {
            const float unseen = std::fabs(even.radiance[c] - seen[c]), whole = std::max(seen[c], 0.0f) + unseen;
            const float light = std::max(coloured[c], 0.0f) + unseen * m_lamp.mean_colour()[c];
            sum.radiance[c] += whole > 0 ? even.radiance[c] * light / whole : 0.0f;
        }
        sum.bend += even.bend * luminance(m_lamp.mean_colour()),
            sum.nearness += even.nearness * luminance(m_lamp.mean_colour());
        for (size_t k = 0; k < pixel.rays.size(); ++k) {
            const float bend = std::fabs(luminance(pixel.weights[k])) * share * m_found[k].bend;
            sum.bend += bend, sum.nearness += m_found[k].nearness * bend;
        }
        sum.nodes += even.nodes + static_cast<float>(pixel.rays.size());
    }

    /// How far the nodes spread in the lobe's widths, over the lobe's own scale there, which grows with the distance from its peak.
    template <class LobeType>
    float spread_over(const PixelLobe<LobeType>& pixel) const {
        Vec2f mean(0, 0);
        float square = 0, nearest = INFINITY;
        for (const SeenNode& node : m_nodes) {
            const Vec2f slope = scaled_slopes(pixel.point, pixel.lobe.mirrored(node.wi));
            mean += slope, square += slope.length2(), nearest = std::min(nearest, slope.length2());
        }
        const float count = static_cast<float>(m_nodes.size());
        return std::sqrt(std::max(square / count - (mean / count).length2(), 0.0f) / (1 + nearest));
    }

    const AreaLight& m_lamp;
    const LightChain& m_lights;
    size_t m_link;
    float m_height = 0;
    std::vector<AreaNode> m_own;
    std::vector<FocusedNode> m_focused;
    std::vector<Vec3f> m_corners;
    std::vector<SeenNode> m_nodes;
    std::vector<TapKernel> m_kernels;
    std::vector<Incident> m_found;
};

}  // namespace

std::vector<DirectLight> direct_light(const LobeParameters& parameters, const LightChain& lights, const SurfaceBatch& batch,
                                      size_t begin, size_t end, const TapRays& taps, std::vector<float>& kept) {
    std::vector<DirectLight> out;
    std::vector<Color3f> weights;
    kept.clear();
    const size_t rays = taps.count();
    for (size_t link = 0; link < lights.links().size(); ++link) {
        const auto* lamp = std::get_if<AreaLight>(lights.links()[link].light.get());
        if (!lamp) continue;
        out.resize(end - begin), kept.resize(lights.links().size() * rays, 1.0f);
        DirectLamp direct(*lamp, lights, link);
        visit_lobe(parameters, [&](const auto& prototype) {
            const bool long_tailed = lobe_tail([&](float xi) { return prototype.border(xi); }) == LobeTail::long_tail;
            for (size_t i = begin, first = 0; i < end; first = taps.ends[i++ - begin]) {
                const ShadingPoint point = shading_point(batch, i, parameters, kWorld);
                const auto lobe = prototype.with_widths(point.mx, point.my);
                const size_t count = taps.ends[i - begin] - first;
                weights.clear();
                for (size_t k = first; k < first + count; ++k) {
                    const float* weight = taps.weights[k].rgba;
                    weights.push_back(Color3f(weight[0], weight[1], weight[2]) * point.scale);
                }
                const LightRay at{batch.p[i], batch.geometric_normal()[i], {}, 0, lobe.side_sign};
                const PixelLobe pixel{lobe, point, at, std::span(taps.rays).subspan(first, count), weights, long_tailed};
                std::fill_n(kept.begin() + static_cast<std::ptrdiff_t>(link * rays + first), count,
                            direct.add(pixel, out[i - begin]));
            }
        });
    }
    return out;
}

}  // namespace burnish
