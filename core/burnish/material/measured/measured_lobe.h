// A measured reflectance made ready to be a lobe: the part above its diffuse base, how wide it is, and how to sample it.
#pragma once

#include <burnish/material/measured/half_vector_sampler.h>
#include <burnish/material/measured/measured_brdf.h>
#include <burnish/material/measured/slope_profile.h>
#include <burnish/material/parameters.h>

#include <memory>

namespace burnish {

/// The diffuse reflectivity that a measurement has everywhere: pi times the reflectance that nine in ten of the pairs exceed, by
/// channel, at most 1. Pairs closer to the horizon than 75 degrees do not count.
Color3f diffuse_base(const MeasuredBrdf& measured);

class MeasuredLobe final : public LobeData {
public:
    /// Of one side of the surface; `kd` is what the lobe leaves out, 0 for all of it.
    MeasuredLobe(std::shared_ptr<const MeasuredBrdf> measured, Side side, const Color3f& kd);

    /// max(f - kd / pi, 0), wo and wi both above the surface: wi is mirrored at it for transmission.
    Color3f eval(const Vec3f& wo, const Vec3f& wi) const;

    const MeasuredBrdf& measured() const { return *m_measured; }
    const Color3f& kd() const { return m_kd; }
    /// Slope widths along t and b; equal for isotropic tables.
    const Vec2f& own_widths() const { return m_own; }
    const SlopeProfile& profile() const { return m_profile; }
    const HalfVectorSampler& sampler() const { return *m_sampler; }

private:
    double slope_density(double slope, float phi) const;
    float width_at(float phi) const;

    std::shared_ptr<const MeasuredBrdf> m_measured;
    Side m_side;
    Color3f m_kd;
    Vec2f m_own;
    SlopeProfile m_profile;
    std::unique_ptr<const HalfVectorSampler> m_sampler;
};

}  // namespace burnish
