// Fresnel reflectance of one interface, per colour channel, as a small value type.
#pragma once

#include <burnish/base/types.h>

namespace burnish {

enum class FresnelKind { none, schlick, dielectric, conductor };

/// F(cos_theta), cos_theta = wo . wm in [0, 1]. `complement` gives 1 - F, for thin transmission (methods: Walkthrough 3.3.1).
struct Fresnel {
    FresnelKind kind = FresnelKind::none;
    Color3f eta{1, 1, 1};        // schlick: r0; dielectric: eta.x = index of refraction; conductor: real part of the index
    Color3f k{0, 0, 0};          // conductor: extinction
    bool complement = false;

    Color3f operator()(float cos_theta) const;
};

}  // namespace burnish
