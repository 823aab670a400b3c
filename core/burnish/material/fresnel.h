// Fresnel reflectance of one interface, per colour channel, as a small value type. Inline: kernels call it once a sample.
#pragma once

#include <burnish/base/types.h>

#include <algorithm>

namespace burnish {

enum class FresnelKind { none, schlick, generalised_schlick, lazanyi, dielectric, conductor };

/// F = r0 + (1 - r0) (1 - c)^5, c = wo . wm. Source: Schlick 1994.
inline Color3f schlick_fresnel(const Color3f& r0, float c) {
    const float m = 1 - c, m2 = m * m, w = m2 * m2 * m;
    return r0 + (Color3f(1) - r0) * w;
}

/// F = f0 + (1 - f0) (1 - c)^5 - f1 c, not below 0: Schlick's with a slope, for measured materials whose reflectance is no
/// plateau. Source: Bandwidth, eq. V.5 (Bagher et al. 2012). It is f0 - f1 from above, 1 at the horizon.
inline Color3f generalised_schlick_fresnel(const Color3f& f0, const Color3f& f1, float c) {
    const Color3f F = schlick_fresnel(f0, c) - f1 * c;
    return {std::max(F.x, 0.0f), std::max(F.y, 0.0f), std::max(F.z, 0.0f)};
}

/// F = r0 + (1 - r0) (1 - c)^5 - dip c (1 - c)^power, not below 0: Schlick's with the dip that metals have before they rise.
/// Source: Lazanyi & Szirmay-Kalos 2005, "Fresnel term approximations for metals".
inline Color3f lazanyi_fresnel(const Color3f& r0, const Color3f& dip, float power, float c) {
    const Color3f F = schlick_fresnel(r0, c) - dip * (c * std::pow(1 - c, power));
    return {std::max(F.x, 0.0f), std::max(F.y, 0.0f), std::max(F.z, 0.0f)};
}

/// Exact unpolarised reflectance from outside onto a dielectric of index `eta` > 0, the ratio of the inner to the outer
/// index; 1 on total reflection (eta < 1). Source: Cook & Torrance 1982, in the form of Walter et al. 2007, eq. 22.
inline float dielectric_fresnel(float eta, float c) {
    const float g2 = eta * eta - 1 + c * c;
    if (g2 <= 0) return eta == 1 ? 0.0f : 1.0f;
    const float g = std::sqrt(g2);
    const float s = (g - c) / (g + c), p = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5f * s * s * (1 + p * p);
}

/// Exact unpolarised reflectance of a conductor of complex index eta + i k (relative to the outside).
/// Source: Born & Wolf, Principles of Optics, 14.2; a2b2 = a^2 + b^2 of (a + i b)^2 = (eta + i k)^2 - sin^2.
inline float conductor_fresnel(float eta, float k, float c) {
    const float c2 = c * c, s2 = 1 - c2;
    const float t = eta * eta - k * k - s2;
    const float a2b2 = std::sqrt(t * t + 4 * eta * eta * k * k);
    const float a2c = 2 * c * std::sqrt(std::max(0.0f, 0.5f * (a2b2 + t)));
    const float rs = (a2b2 + c2 - a2c) / (a2b2 + c2 + a2c);
    const float u = c2 * a2b2 + s2 * s2, v = a2c * s2;
    return 0.5f * rs * (1 + (u - v) / (u + v));
}

/// F(cos_theta), cos_theta = wo . wm in [0, 1]. `complement` gives 1 - F, for thin transmission (methods: Walkthrough 3.3.1).
/// `none` is 1 either way: a lobe without Fresnel is as strong as its strength says, on both sides.
struct Fresnel {
    FresnelKind kind = FresnelKind::none;
    Color3f eta{1, 1,
                1};      // schlick, lazanyi: r0; generalised: f0; dielectric: eta.x = index; conductor: real part of the index
    Color3f k{0, 0, 0};  // conductor: extinction; generalised: f1; lazanyi: dip
    bool complement = false;
    float power = 5;  // lazanyi

    Color3f operator()(float cos_theta) const {
        if (kind == FresnelKind::none) return Color3f(1);
        const Color3f F = reflectance(std::clamp(cos_theta, 0.0f, 1.0f));
        return complement ? Color3f(1) - F : F;
    }

private:
    Color3f reflectance(float c) const {
        switch (kind) {
            case FresnelKind::schlick: return schlick_fresnel(eta, c);
            case FresnelKind::generalised_schlick: return generalised_schlick_fresnel(eta, k, c);
            case FresnelKind::lazanyi: return lazanyi_fresnel(eta, k, power, c);
            case FresnelKind::dielectric: return Color3f(dielectric_fresnel(eta.x, c));
            case FresnelKind::conductor:
                return {conductor_fresnel(eta.x, k.x, c), conductor_fresnel(eta.y, k.y, c), conductor_fresnel(eta.z, k.z, c)};
            case FresnelKind::none: break;
        }
        return Color3f(1);
    }
};

}  // namespace burnish
