// A whole material as one function of two directions: what a measurement of it would show.
#pragma once

#include <burnish/material/any_model.h>
#include <burnish/material/parameters.h>

#include <vector>

namespace burnish {

class MaterialBrdf {
public:
    /// Layers play no part; a coupled diffuse part counts as uncoupled.
    explicit MaterialBrdf(const Material& material);

    /// kd / pi and all lobes, strength and tint included, 1/sr. Local frame, unit vectors, wo.z > 0; wi below the surface: what
    /// transmission lobes let through.
    Color3f operator()(const Vec3f& wo, const Vec3f& wi) const;

private:
    struct OneLobe {
        AnyModel model;
        Color3f weight;
        float side_sign, cosine, sine;  // of its rotation about the normal
    };

    Color3f m_diffuse;
    std::vector<OneLobe> m_lobes;
};

}  // namespace burnish
