#include <burnish/shading/area_shading.h>

#include <burnish/material/lobe.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/shading_point.h>
#include <burnish/shading/tap.h>

#include <algorithm>

namespace burnish {
float kFine = 0.6f, kCoarse = 1.2f;
namespace {

const Matrix33f kWorld;

// spread of the nodes over the lobe's own scale: resolved up to the one, not from the other

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
    Vec3f wi;         // world
    float angle;      // radius of the part it stands for
    Color3f flux{0};  // arriving, radiance times solid angle
};

class Residual {
public:
    Residual(const AreaLight& light, const LightChain& lights, size_t link) : m_light(light), m_lights(lights), m_link(link) {}

    template <class LobeType>
    Color3f operator()(const LobeType& lobe, const ShadingPoint& point, const Vec3f& p, const Vec3f& ng,
                       std::span<const TapKernel> taps, float& evaluated) {
        const float height = m_light.polygon().height(p);
        if (!(height > 0) && !(m_light.is_two_sided() && height < 0)) return Color3f(0);
        look_from(p, std::fabs(height));
        const float w = resolved(lobe, point);
        if (!(w > 0)) return Color3f(0);
        Color3f sum(0);
        for (const SeenNode& node : m_nodes) {
            const Vec3f wi = point.frame.to_local(node.wi);
            const float cos_i = wi.z * lobe.side_sign, edge = 1 / std::max(node.angle, 1e-4f);
            Color3f missing(0);
            if (cos_i > 0)
                missing = lobe.eval(point.wo, wi) * point.scale *
                          (cos_i * visible_share(cos_i, point.ng.dot(wi) * lobe.side_sign, edge));
            const float above = std::clamp(0.5f + 0.5f * ng.dot(node.wi) * lobe.side_sign * edge, 0.0f, 1.0f);
            for (const TapKernel& tap : taps) missing -= tap.at(node.wi) * above;
            sum += missing * node.flux * m_lights.left_for(m_link, {p, ng, node.wi, node.angle});
        }
        evaluated += static_cast<float>(m_nodes.size());
        return sum * w;
    }

private:
    void look_from(const Vec3f& p, float height) {
        m_nodes.clear();
        for (const AreaNode& node : m_light.nodes()) {
            const Vec3f way = node.p - p;
            const float distance = way.length();
            m_nodes.push_back(
                {way / distance, node.radius / distance, node.power * (height / (distance * distance * distance))});
        }
    }

    /// In slopes of the half vector, in units of the lobe's widths: how far the nodes spread, over the lobe's own scale there, which
    /// grows with the distance from the peak.
    template <class LobeType>
    float resolved(const LobeType& lobe, const ShadingPoint& point) const {
        Vec2f mean(0, 0);
        float square = 0, nearest = INFINITY;
        for (const SeenNode& node : m_nodes) {
            Vec2f slope = half_slopes(point.wo, lobe.mirrored(point.frame.to_local(node.wi)));
            slope.x /= point.mx, slope.y /= point.my;
            const float length2 = slope.length2();
            mean += slope, square += length2, nearest = std::min(nearest, length2);
        }
        const float count = static_cast<float>(m_nodes.size());
        const float spread2 = square / count - (mean / count).length2();
        const float ratio = std::sqrt(std::max(spread2, 0.0f) / (1 + nearest));
        const float x = std::clamp((kCoarse - ratio) / (kCoarse - kFine), 0.0f, 1.0f);
        return x * x * (3 - 2 * x);
    }

    const AreaLight& m_light;
    const LightChain& m_lights;
    size_t m_link;
    std::vector<SeenNode> m_nodes;
};

}  // namespace

void add_area_residuals(const LobeParameters& parameters, const LightChain& lights, const SurfaceBatch& batch, size_t begin,
                        size_t end, const TapRays& taps, std::span<Color3f> overlay, std::span<float> samples) {
    std::vector<TapKernel> kernels;
    for (size_t link = 0; link < lights.links().size(); ++link) {
        const auto* light = std::get_if<AreaLight>(lights.links()[link].light.get());
        if (!light) continue;
        Residual residual(*light, lights, link);
        visit_lobe(parameters, [&](const auto& prototype) {
            for (size_t i = begin, k = 0; i < end; ++i) {
                const ShadingPoint point = shading_point(batch, i, parameters, kWorld);
                kernels.clear();
                for (; k < taps.ends[i - begin]; ++k) {
                    const float* weight = taps.weights[k].rgba;
                    kernels.emplace_back(taps.rays[k], Color3f(weight[0], weight[1], weight[2]) * point.scale);
                }
                const auto lobe = prototype.with_widths(point.mx, point.my);
                overlay[i] += residual(lobe, point, batch.p[i], batch.geometric_normal()[i], kernels, samples[i]);
            }
        });
    }
}

}  // namespace burnish
