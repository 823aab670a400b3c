#include <burnish/light/environment_light.h>

#include <burnish/light/gaussian_stack.h>
#include <burnish/light/light_mean.h>

namespace burnish {

void EnvironmentLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    const GaussianStack& stack = m_environment->gaussian_stack();
    const Color3f gain = m_environment->gain();
    for (size_t i = 0; i < rays.size(); ++i) {
        const Vec3f d = rays[i].d * m_environment->world_to_light();
        const std::array<float, 4> rgba = stack.stack().lookup_rgba(d, stack.level(rays[i].sigma));
        out[i] = {gain * Color3f(rgba[0], rgba[1], rgba[2]), 1.0f, luminance(gain) * rgba[3], 0.0f};
    }
}

ExactLight EnvironmentLight::exact(const LightRay& ray) const {
    const Vec3f d = ray.d * m_environment->world_to_light();
    return {m_environment->radiance(d) * m_environment->gain(), 1.0f, m_environment->pdf(d)};
}

LightDraw EnvironmentLight::sample(const Vec3f&, const Vec2f& u) const {
    LightDraw draw;
    draw.d = m_environment->sample(u, draw.pdf) * m_environment->world_to_light().transposed();
    return draw;
}

float EnvironmentLight::mean_luminance() const {
    return luminance(m_environment->gain()) * burnish::mean_luminance(m_environment->gaussian_stack().stack());
}

}  // namespace burnish
