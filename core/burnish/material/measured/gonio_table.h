// Reflectance measured pair by pair with a goniometer: few incident directions, many outgoing ones for each.
//
// Values are kept by incident direction over the half vector's projection (h.x, h.y). Between incident directions the same half
// vector is looked up for the nearest ones: outgoing directions that are equally far from each one's mirror direction, so that a
// highlight moves instead of fading in one place and out in another. For materials that throw light back where it came from this
// fails, as half vectors say nothing about them. Source: Walkthrough 3.2 after Rusinkiewicz 1998.
#pragma once

#include <burnish/material/measured/measured_brdf.h>

#include <memory>

namespace burnish {

class GonioTable final : public MeasuredBrdf {
public:
    /// Pairs as `BrdfSample` has them, at least one. The incident direction is wi of a reflected pair, wo of a transmitted one
    /// (a thin sheet is reciprocal). `isotropic`: only the difference of the azimuths counts, and not its sign.
    GonioTable(std::vector<BrdfSample> samples, bool isotropic);

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const override;
    bool is_isotropic() const override { return m_isotropic; }
    bool transmits() const override { return m_through != nullptr; }
    std::vector<BrdfSample> samples() const override { return m_samples; }

private:
    class Side;

    bool m_isotropic;
    std::vector<BrdfSample> m_samples;
    std::shared_ptr<const Side> m_reflected, m_through;  // null: nothing was measured there
};

}  // namespace burnish
