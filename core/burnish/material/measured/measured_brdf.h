// A BRDF as somebody measured it: values for pairs of directions, and something sensible in between.
#pragma once

#include <burnish/base/types.h>

#include <string>
#include <vector>

namespace burnish {

/// One measured pair. Local frame (z = n), unit vectors, wo.z > 0; wi below the surface: light that comes through a sheet.
struct BrdfSample {
    Vec3f wo, wi;
    Color3f f;  // 1/sr, without a cosine
};

/// No measurement goes beyond this, in 1/sr: a perfect mirror within 1e-5 rad. Larger numbers are errors.
inline constexpr float kLargestReflectance = 1e9f;

class MeasuredBrdf {
public:
    virtual ~MeasuredBrdf() = default;

    /// f(wo, wi) in 1/sr, RGB, finite and >= 0; 0 below the surface unless it transmits. Any unit vectors, thread-safe.
    virtual Color3f eval(const Vec3f& wo, const Vec3f& wi) const = 0;
    /// Turning both directions about the normal changes nothing.
    virtual bool is_isotropic() const = 0;
    virtual bool transmits() const = 0;
    /// Values lie so densely that slices through them mean something, not only the pairs themselves.
    virtual bool is_dense() const { return false; }
    /// The pairs that were measured and are valid, in the order of the file; regular tables thin them out to some 100,000.
    virtual std::vector<BrdfSample> samples() const = 0;

    /// Where it came from, for messages and for the material that shows it: the file's path.
    const std::string& file() const { return m_file; }
    void set_file(const std::string& file) { m_file = file; }

private:
    std::string m_file;
};

}  // namespace burnish
