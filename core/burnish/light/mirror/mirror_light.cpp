#include <burnish/light/mirror/mirror_light.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kLeastSigma = 1e-3f;                       // radian: of the fade at the plane, so that it is no step
constexpr float kSurelySeen = 1.0f, kSurelyHidden = 4.0f;  // misses over widths

/// 1 at `from`, 0 at `to`, smooth.
float fade(float x, float from, float to) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return 1 - t * t * (3 - 2 * t);
}

Image multiplied(Image light, const Color3f& gain) {
    for (size_t i = 0; i < light.pixel_count(); ++i)
        for (int k = 0; k < 3; ++k) light.at(i)[k] *= gain[k];
    return light;
}

/// Luminance of what is covered.
float mean_of(const Image& light) {
    double sum = 0, cover = 0;
    for (size_t i = 0; i < light.pixel_count(); ++i) {
        const float* rgba = light.at(i);
        sum += luminance({rgba[0], rgba[1], rgba[2]}), cover += rgba[3];
    }
    return cover > 0 ? static_cast<float>(sum / cover) : 0.0f;
}

Vec3f away_from(const Vec3f& centre, const Plane& plane) {
    const Vec3f n = plane.normal.normalized();
    return n.dot(centre - plane.point) > 0 ? -n : n;
}

}  // namespace

MirrorLight::MirrorLight(const MirrorBuffer& buffer, const MirrorSettings& settings, const Color3f& gain)
    : m_view(buffer.camera, buffer.data, buffer.display, buffer.position, buffer.normal),
      m_light(multiplied(buffer.light, gain)),
      m_away(away_from(buffer.camera.centre, settings.plane)),
      m_steps(settings.second_step ? 3 : 1),
      m_mean(mean_of(buffer.light) * luminance(gain)) {}

void MirrorLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    for (size_t i = 0; i < rays.size(); ++i) out[i] = incident(rays[i]);
}

ExactLight MirrorLight::exact(const LightRay& ray) const {
    const Incident found = incident({ray.p, ray.ng, ray.d, 0});
    return {found.radiance, found.cover, 0};
}

Incident MirrorLight::incident(const LightRay& ray) const {
    const float width = std::max(ray.sigma, kLeastSigma), above = fade(-m_away.dot(ray.d), -width, width);
    const MirrorView::Found found = m_view.find(ray.p, ray.d, m_steps);
    if (!(above > 0) || !MirrorView::is_seen(found)) return {};
    const float spread2 = found.across.cross(found.down).length();  // square pixels per steradian
    const float sigma = ray.sigma * std::sqrt(spread2);
    const float seen = fade(found.miss / std::max(sigma, 1.0f), kSurelySeen, kSurelyHidden), share = above * seen;
    if (!(share > 0)) return {};
    const PlanarStack::Value value = m_light.lookup(found.place, sigma);
    const float longest2 = found.across.length2() + found.down.length2();
    return {value.radiance * share, value.cover * share, value.bend * share * longest2, found.nearness};
}

}  // namespace burnish
