#include <burnish/light/environment_light.h>

#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/filter/stack_lookup.h>
#include <burnish/light/light_mean.h>

namespace burnish {
namespace {

constexpr size_t kAtOnce = 128;  // lookups

}  // namespace

void EnvironmentLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    const GaussianStack& stack = m_environment->gaussian_stack();
    const Color3f gain = m_environment->gain();
    std::array<StackPlace, kAtOnce> places;
    std::array<std::array<float, 4>, kAtOnce> rgba;
    for (size_t begin = 0; begin < rays.size(); begin += kAtOnce) {
        const size_t count = std::min(kAtOnce, rays.size() - begin);
        for (size_t i = 0; i < count; ++i)
            places[i] = {rays[begin + i].d * m_environment->world_to_light(), stack.quick_level(rays[begin + i].sigma)};
        look_up(stack.stack(), std::span(places).first(count), {gain.x, gain.y, gain.z, luminance(gain)}, rgba);
        for (size_t i = 0; i < count; ++i)
            out[begin + i] = {Color3f(rgba[i][0], rgba[i][1], rgba[i][2]), 1.0f, rgba[i][3], 0.0f};
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
    return luminance(m_environment->gain()) * burnish::mean_luminance(m_environment->gaussian_stack());
}

}  // namespace burnish
