// A reflectance known as a curve over the angle of the half vector alone: one slice of a table.
#pragma once

#include <burnish/material/measured/measured_brdf.h>

#include <utility>

namespace burnish {

class HalfAngleCurve final : public MeasuredBrdf {
public:
    /// (cos theta_h, f in 1/sr), in any order, at least one.
    explicit HalfAngleCurve(std::vector<std::pair<float, Color3f>> points);

    /// Linear in theta_h, kept beyond the ends.
    Color3f eval(const Vec3f& wo, const Vec3f& wi) const override;
    bool is_isotropic() const override { return true; }
    bool transmits() const override { return false; }
    /// With both directions along the half vector.
    std::vector<BrdfSample> samples() const override;

private:
    std::vector<std::pair<float, Color3f>> m_points;  // by rising theta_h, in radians
};

}  // namespace burnish
