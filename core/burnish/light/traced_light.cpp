#include <burnish/light/traced_light.h>

#include <burnish/base/error.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kMostRays = 64;
constexpr float kGoldenAngle = 2.39996323f;
constexpr float kHalfFloat = 1e-3f;    // positions may be half floats: how far they may lie off the surface, of their size
constexpr float kFarFloat = 1e-5f;     // how far a ray starts off the surface, of the size of its place and of the scene
constexpr float kSteepest = 0.484f;    // half the integral of |g''|, g a Gaussian of width 1
constexpr float kDiscOfSigma = 4;      // diameter of the disc that spreads as much as a Gaussian of width 1
constexpr float kLeastCosine = 0.05f;  // of footprints on surfaces seen at a grazing angle

/// Golden spiral through the equal parts of a Gaussian's mass, drawn together so that with parts of width `part` the whole has
/// width 1 again.
std::vector<Vec2f> bundle_of(int rays, float part) {
    std::vector<Vec2f> places;
    float square = 0;
    for (int i = 0; i < rays; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(rays), phi = kGoldenAngle * static_cast<float>(i);
        const float r2 = -2 * std::log(1 - u);
        places.push_back(Vec2f(std::cos(phi), std::sin(phi)) * std::sqrt(r2));
        square += r2 / static_cast<float>(rays);
    }
    for (Vec2f& place : places) place *= std::sqrt(2 * (1 - part * part) / square);
    return places;
}

/// `place` widths of a spherical Gaussian off the axis n.
Vec3f off_axis(const Frame& frame, const Vec2f& place, float sigma) {
    const float versine = std::min(0.5f * place.length2() * sigma * sigma, 2.0f), cosine = 1 - versine;
    const float sine = std::sqrt(versine * (1 + cosine)), length = place.length();
    if (!(length > 0)) return frame.n;
    return (frame.t * place.x + frame.b * place.y) * (sine / length) + frame.n * cosine;
}

/// d, mirrored up where it lies below the horizon of n: nothing comes from there.
Vec3f folded(const Vec3f& d, const Vec3f& n) { return d - n * (2 * std::min(n.dot(d), 0.0f)); }

float size_of(const Vec3f& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

}  // namespace

/// Where the rays of a shaded point start: on the surface that the scene has there, a little to the side they leave by.
class TracedLight::Start {
public:
    Start(const LitScene& scene, const LightRay& ray) : m_p(ray.p), m_ng(ray.ng), m_on(ray.p), m_up(ray.ng) {
        m_off = kFarFloat * (size_of(ray.p) + scene.extent());
        const float reach = kHalfFloat * size_of(ray.p) + m_off;
        if (const auto hit = scene.tracer().closest(ray.p + ray.ng * reach, -ray.ng, 0, 2 * reach))
            m_on = hit->p, m_up = hit->ng;
    }

    bool is_of(const LightRay& ray) const { return ray.p == m_p && ray.ng == m_ng; }
    Vec3f towards(const Vec3f& d) const { return m_on + m_up * std::copysign(m_off, m_ng.dot(d)); }

private:
    Vec3f m_p, m_ng, m_on, m_up;
    float m_off;
};

TracedLight::TracedLight(std::shared_ptr<const LitScene> scene, int rays, const Color3f& gain)
    : m_scene(std::move(scene)), m_part(1 / std::sqrt(static_cast<float>(std::max(rays, 1)))), m_gain(gain) {
    if (rays < 1 || rays > kMostRays)
        throw Error(ErrorCode::bad_argument,
                    "traced light: rays is " + std::to_string(rays) + ", expected 1 to " + std::to_string(kMostRays));
    m_bundle = bundle_of(rays, m_part);
}

void TracedLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    std::optional<Start> start;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!start || !start->is_of(rays[i])) start.emplace(*m_scene, rays[i]);
        out[i] = bundle(*start, rays[i]);
    }
}

Incident TracedLight::bundle(const Start& start, const LightRay& ray) const {
    const Frame frame = Frame::along(ray.d, ray.ng);
    const float side = std::copysign(1.0f, ray.ng.dot(ray.d)), share = 1 / static_cast<float>(m_bundle.size());
    Incident sum;
    float darkest = std::numeric_limits<float>::infinity(), brightest = 0;
    for (const Vec2f& place : m_bundle) {
        const Met met = meet(start, folded(off_axis(frame, place, ray.sigma), ray.ng * side), m_part * ray.sigma);
        sum.radiance += met.radiance * share, sum.cover += met.cover * share, sum.nearness += met.nearness;
        darkest = std::min(darkest, luminance(met.radiance)), brightest = std::max(brightest, luminance(met.radiance));
    }
    sum.nearness *= sum.cover > 0 ? share / sum.cover : 0;
    const float width2 = ray.sigma * ray.sigma, range = brightest - darkest;
    sum.bend = range > 0 ? kSteepest * range / width2 : 0;
    return sum;
}

TracedLight::Met TracedLight::meet(const Start& start, const Vec3f& d, float sigma) const {
    const auto hit = m_scene->tracer().closest(start.towards(d), d);
    if (!hit) return {};
    const float cosine = std::max(std::abs(hit->ng.dot(d)), kLeastCosine);
    const float width = kDiscOfSigma * sigma * hit->distance / std::sqrt(cosine);
    return {m_scene->light().radiance(*hit, width) * m_gain, 1, 1 / hit->distance};
}

ExactLight TracedLight::exact(const LightRay& ray) const {
    const Met met = meet(Start(*m_scene, ray), ray.d, 0);
    return {met.radiance, met.cover, m_scene->lamps().pdf(ray.p, ray.d)};
}

}  // namespace burnish
