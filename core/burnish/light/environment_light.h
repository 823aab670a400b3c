// An environment map as one of several lights: what is left when everything near has been asked.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/light/light_ray.h>

#include <memory>
#include <span>

namespace burnish {

/// Covers every direction. Its bright discs are not part of `lookup`; they are shaded apart (disc_light.h).
class EnvironmentLight {
public:
    explicit EnvironmentLight(std::shared_ptr<const Environment> environment) : m_environment(std::move(environment)) {}

    void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;
    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const { return true; }
    LightDraw sample(const Vec3f& p, const Vec2f& u) const;
    float mean_luminance() const;

    const Environment& environment() const { return *m_environment; }

private:
    std::shared_ptr<const Environment> m_environment;
};

}  // namespace burnish
