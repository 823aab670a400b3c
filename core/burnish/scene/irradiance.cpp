#include <burnish/base/error.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/irradiance.h>

#include <bit>
#include <string>

namespace burnish {
namespace {

/// Unit vector about +Z with density cos / pi.
Vec3f cosine_direction(const Vec2f& u) {
    const float r = std::sqrt(u.x), phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)};
}

/// Index i of a Sobol' sequence taken in another order: runs of 2^k stay runs, so each is still a net, but pairs of points
/// from two orders are independent. Source: Burley 2020, "Practical Hash-based Owen Scrambling", 3.1.
uint32_t shuffled(uint32_t i, uint32_t seed) { return reverse_bits(owen_scramble_reversed(reverse_bits(i), hash_bits(seed))); }

}  // namespace

IrradianceGatherer::IrradianceGatherer(const Tracer& tracer, const DistantLight& light, int bounce_samples)
    : m_tracer(tracer), m_light(light) {
    if (light.samples.size() < kRuns || !std::has_single_bit(light.samples.size()))
        throw Error(ErrorCode::bad_argument, "distant light has " + std::to_string(light.samples.size()) +
                                                 " samples, expected a power of two, 16 or more");
    const auto count = static_cast<uint32_t>(bounce_samples * kRuns), lights = static_cast<uint32_t>(light.samples.size());
    for (uint32_t i = 0; i < count; ++i)
        m_bounces.push_back({cosine_direction(owen_sobol(i, 1)), shuffled(i, 2) & (lights - 1)});
}

Irradiance IrradianceGatherer::gather(const Hit& hit, int first, int count) const {
    const Vec3f origin = leaving_point(hit);
    const Frame frame = Frame::around(hit.n);
    const size_t light_run = m_light.samples.size() / kRuns, bounce_run = m_bounces.size() / kRuns;
    const auto begin = static_cast<size_t>(first), end = static_cast<size_t>(first + count);
    Irradiance e;
    for (size_t i = begin * light_run; i < end * light_run; ++i) e.direct += from_sky(origin, hit.n, m_light.samples[i]);
    for (size_t i = begin * bounce_run; i < end * bounce_run; ++i) e.indirect += bounced(origin, frame, m_bounces[i]);
    if (bounce_run > 0) e.indirect *= kPi / static_cast<float>(m_bounces.size());
    return e * (static_cast<float>(kRuns) / static_cast<float>(count));
}

/// One sample's share of the irradiance.
Color3f IrradianceGatherer::from_sky(const Vec3f& origin, const Vec3f& n, const LightSample& sample) const {
    const float cos_theta = n.dot(sample.wi);
    if (cos_theta <= 0 || m_tracer.occluded(origin, sample.wi)) return Color3f(0.0f);
    return sample.weight * cos_theta;
}

/// Radiance that the matte surface the bounce meets sends back, lit by one sample of the sky.
Color3f IrradianceGatherer::bounced(const Vec3f& origin, const Frame& frame, const Bounce& bounce) const {
    const auto hit = m_tracer.closest(origin, frame.to_world(bounce.wi));
    if (!hit) return Color3f(0.0f);
    const Color3f e = from_sky(leaving_point(*hit), hit->n, m_light.samples[bounce.light]);
    const Color3f& albedo = m_tracer.scene().objects[static_cast<size_t>(hit->object)].albedo;
    return albedo * e * (static_cast<float>(m_light.samples.size()) / kPi);
}

}  // namespace burnish
