#include <burnish/light/traced/traced_light.h>

#include <burnish/base/error.h>
#include <burnish/sampling/sequence.h>

#include <algorithm>
#include <optional>

namespace burnish {
namespace {

constexpr int kMostRays = 64;
constexpr float kLeastSigma = 1e-4f;   // radian
constexpr float kSteepest = 0.484f;    // half the integral of |g''|, g a Gaussian of width 1
constexpr float kDiscOfSigma = 4;      // diameter of the disc that spreads as much as a Gaussian of width 1
constexpr float kLeastCosine = 0.05f;  // of footprints on surfaces seen at a grazing angle

int checked(int rays) {
    if (rays >= 1 && rays <= kMostRays) return rays;
    throw Error(ErrorCode::bad_argument,
                "traced light: rays is " + std::to_string(rays) + ", expected 1 to " + std::to_string(kMostRays));
}

/// What a ray along d met, averaged over a Gaussian `sigma` radian wide.
Color3f seen(const LitScene& scene, const Hit& hit, const Vec3f& d, float sigma) {
    const float cosine = std::max(std::abs(hit.ng.dot(d)), kLeastCosine);
    return scene.light().radiance(hit, kDiscOfSigma * sigma * hit.distance / std::sqrt(cosine));
}

/// Mean luminance, as a display weighs it (light_mean.h), of what rays meet that start all over the middle half of the scene's box, in all directions.
float mean_of(const LitScene& scene) {
    constexpr uint32_t kRays = 1024;
    const Imath::Box3f& box = scene.box();
    float sum = 0, met = 0;
    for (uint32_t i = 0; i < kRays; ++i) {
        const Vec2f at = owen_sobol(i, 1), across = owen_sobol(i, 2);
        const float z = 1 - 2 * at.x, phi = 2 * kPi * at.y, r = std::sqrt(1 - z * z);
        const Vec3f place = Vec3f(across.x, across.y, at.x) * 0.5f + Vec3f(0.25f);
        const auto hit = scene.tracer().closest(box.min + box.size() * place, {r * std::cos(phi), r * std::sin(phi), z});
        if (hit) sum += std::sqrt(luminance(scene.light().radiance(*hit))), met += 1;
    }
    return met > 0 ? (sum / met) * (sum / met) : 0.0f;
}

/// The sums of a cone, from its rays and from the lamps' points.
class ConeSum {
public:
    ConeSum(const Cone& cone, const RayBundle& bundle)
        : m_cone(cone), m_bundle(bundle), m_rays(static_cast<float>(bundle.places().size())) {}

    void miss() { m_darkest = 0; }

    /// Ray i, towards d. `lamps`: density of the lamps' points there, per steradian.
    void add_ray(size_t i, const Vec3f& d, const Color3f& radiance, float nearness, float lamps) {
        float share = 1 / m_rays;
        if (lamps > 0) {
            const float g = m_cone.density(m_cone.squares(d)), own = std::exp(-0.5f * m_bundle.places()[i].length2());
            share *= m_bundle.mean_share(i, lamps * own / (m_rays * g));
        }
        add(radiance * share, nearness);
        const float whole = luminance(radiance) * share * m_rays;
        m_cover += 1 / m_rays, m_darkest = std::min(m_darkest, whole), m_brightest = std::max(m_brightest, whole);
    }

    void add_lamp(const SeenLamp& lamp) {
        const Vec2f squares = m_cone.squares(lamp.d);
        const float g = m_cone.density(squares), rays = m_rays * g, points = lamp.density;
        const Color3f light = lamp.radiance * (g * points / (rays * rays + points * points));
        add(light, lamp.nearness);
        m_bend += luminance(light) * (1 + squares.x);
    }

    Incident result(const Color3f& gain) const {
        Incident sum;
        const float width2 = m_cone.sigma() * m_cone.sigma();
        sum.radiance = m_radiance * gain, sum.cover = m_cover;
        sum.bend = (kSteepest * std::max(m_brightest - m_darkest, 0.0f) + m_bend) / width2 * luminance(gain);
        sum.nearness = m_weight > 0 ? m_nearness / m_weight : 0;
        return sum;
    }

private:
    static constexpr float kDark = 1e-6f;  // so that black surfaces have a distance

    void add(const Color3f& light, float nearness) {
        const float weight = luminance(light) + kDark;
        m_radiance += light, m_nearness += weight * nearness, m_weight += weight;
    }

    const Cone& m_cone;
    const RayBundle& m_bundle;
    float m_rays, m_cover = 0, m_bend = 0, m_nearness = 0, m_weight = 0;
    float m_darkest = std::numeric_limits<float>::infinity(), m_brightest = 0;
    Color3f m_radiance{0, 0, 0};
};

}  // namespace

TracedLight::TracedLight(std::shared_ptr<const LitScene> scene, int rays, const Color3f& gain)
    : m_scene(std::move(scene)), m_bundle(checked(rays)), m_gain(gain), m_mean(mean_of(*m_scene)) {}

void TracedLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    std::optional<TracedStart> start;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!start || !start->is_of(rays[i])) start.emplace(*m_scene, rays[i]);
        out[i] = averaged(*start, rays[i]);
    }
}

Incident TracedLight::averaged(TracedStart& start, const LightRay& ray) const {
    const Cone cone(ray.d, start.up(), std::max(ray.sigma, kLeastSigma));
    const Lamps& lamps = m_scene->lamps();
    ConeSum sum(cone, m_bundle);
    for (size_t i = 0; i < m_bundle.places().size(); ++i) {
        const Vec3f d = cone.direction(m_bundle.places()[i]);
        const auto hit = m_scene->tracer().closest(start.origin(), d, 0, kInfinitelyFar, start.hidden());
        if (!hit) {
            sum.miss();
            continue;
        }
        const float density = lamps.density(*hit) * hit->distance * hit->distance / std::abs(hit->ng.dot(d));
        sum.add_ray(i, d, seen(*m_scene, *hit, d, m_bundle.part() * cone.sigma()), 1 / hit->distance, density);
    }
    for (const SeenLamp& lamp : start.lamps()) sum.add_lamp(lamp);
    return sum.result(m_gain);
}

ExactLight TracedLight::exact(const LightRay& ray) const {
    const float pdf = m_scene->lamps().pdf(ray.p, ray.d);
    const TracedStart start(*m_scene, ray);
    const auto hit = m_scene->tracer().closest(start.origin(), ray.d, 0, kInfinitelyFar, start.hidden());
    if (!hit) return {Color3f(0, 0, 0), 0, pdf};
    return {m_scene->light().radiance(*hit) * m_gain, 1, pdf};
}

}  // namespace burnish
