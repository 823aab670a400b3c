// Light that arrives at surface points of a scene: the sky with shadows, and one bounce between matte objects.
#pragma once

#include <burnish/scene/trace.h>

#include <functional>
#include <vector>

namespace burnish {

/// One sample of the distant light: where it comes from and radiance / (pdf * number of samples), so that the sum of
/// weight * cos over all samples estimates irradiance.
struct LightSample {
    Vec3f wi;  // world space, unit
    Color3f weight;
};

/// Distant light as the tracer sees it.
struct DistantLight {
    std::function<Color3f(const Vec3f& d)> radiance;  // world space: what the camera sees where it hits nothing
    std::vector<LightSample> samples;                 // 16 * 2^k, drawn with the points of a Sobol' sequence in order
};

struct Irradiance {
    Color3f direct{0.0f}, indirect{0.0f};
    void operator+=(const Irradiance& e) { direct += e.direct, indirect += e.indirect; }
    Irradiance operator*(float s) const { return {direct * s, indirect * s}; }
};

/// Gathers irradiance with a fixed set of samples cut into 16 runs. A run alone is a coarse estimate, any run as fair as any
/// other; all of them together are the fine one.
class IrradianceGatherer {
public:
    static constexpr int kRuns = 16;

    /// Tracer and light must outlive the gatherer. `bounce_samples`: rays per run that look for light from other objects, a
    /// power of two, or 0. Throws Error(bad_argument) when the light's samples are not 16 * 2^k.
    IrradianceGatherer(const Tracer& tracer, const DistantLight& light, int bounce_samples);

    /// Irradiance at a hit by `count` runs from `first` on. Thread-safe, deterministic.
    Irradiance gather(const Hit& hit, int first, int count) const;

private:
    struct Bounce {
        Vec3f wi;        // cosine-distributed, local frame
        uint32_t light;  // the sample of the sky that lights what it meets
    };
    Color3f from_sky(const Vec3f& origin, const Vec3f& n, const LightSample& sample) const;
    Color3f bounced(const Vec3f& origin, const Frame& frame, const Bounce& bounce) const;

    const Tracer& m_tracer;
    const DistantLight& m_light;
    std::vector<Bounce> m_bounces;
};

}  // namespace burnish
