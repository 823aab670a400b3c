#include <burnish/material/import/surface_numbers.h>

#include <burnish/material/lobes/microfacet.h>

#include <algorithm>

namespace burnish {
namespace {

/// F = f0 + (f90 - f0) (1 - c)^5 as a tint and a curve that ends at 1.
void set_fresnel(const Color3f& f0, const Color3f& f90, LobeParameters& lobe) {
    constexpr float kSteepestFall = 500;  // a curve that falls to nothing ends at that much less instead
    for (int c = 0; c < 3; ++c) {
        lobe.tint[c] = std::max(f90[c], f0[c] / kSteepestFall);
        lobe.fresnel.eta[c] = lobe.tint[c] > 0 ? f0[c] / lobe.tint[c] : 0.0f;
    }
    const Color3f& r0 = lobe.fresnel.eta;
    lobe.fresnel.kind = std::max({r0.x, r0.y, r0.z}) > 1 ? FresnelKind::generalised_schlick : FresnelKind::schlick;
    lobe.fresnel.k = Color3f(0);
}

LobeParameters lobe_of(const Interface& face, float strength) {
    LobeParameters lobe;
    lobe.model = ModelId::ggx;
    lobe.strength = strength;
    lobe.mx = std::clamp(face.alpha.x, kMinWidth, 1.0f), lobe.my = std::clamp(face.alpha.y, kMinWidth, 1.0f);
    lobe.rotation = face.rotation;
    set_fresnel(face.f0, face.f90, lobe);
    return lobe;
}

/// What the coat's own colour leaves of what is below it.
Color3f coat_tint(const SurfaceNumbers& numbers) {
    return Color3f(1) + (numbers.coat_color - Color3f(1)) * numbers.coat_weight;
}

/// What is seen of an interface through the coat.
Interface below_coat(Interface face, const SurfaceNumbers& numbers) {
    face.f0 = face.f0 * coat_tint(numbers) * (Color3f(1) - numbers.coat.f0 * numbers.coat_weight);
    face.f90 = face.f90 * coat_tint(numbers) * (Color3f(1) - numbers.coat.f90 * numbers.coat_weight);
    return face;
}

LobeParameters transmission_of(const SurfaceNumbers& numbers, float strength) {
    LobeParameters lobe = lobe_of(numbers.dielectric, strength);
    lobe.side = Side::transmission;
    lobe.fresnel.complement = true;
    lobe.tint = numbers.transmission_color * coat_tint(numbers) * (Color3f(1) - numbers.coat.f0 * numbers.coat_weight);
    return lobe;
}

}  // namespace

float f0_of_ior(float ior) {
    const float amplitude = (ior - 1) / (ior + 1);
    return amplitude * amplitude;
}

Material material_of(const std::string& name, const SurfaceNumbers& numbers) {
    Material material;
    material.name = name;
    material.kd_coupled = true;
    const float clear = (1 - numbers.metallic) * numbers.transmission;
    material.kd = numbers.base * coat_tint(numbers) * (1 - numbers.metallic - clear);
    const Interface metal{numbers.base, Color3f(1), numbers.dielectric.alpha, numbers.dielectric.rotation};
    const auto add = [&](const Interface& face, float strength) {
        const LobeParameters lobe = lobe_of(face, strength);
        if (strength > 0 && lobe.tint != Color3f(0)) material.lobes.push_back(lobe);
    };
    add(below_coat(numbers.dielectric, numbers), 1 - numbers.metallic);
    add(below_coat(metal, numbers), numbers.metallic);
    if (clear > 0) material.lobes.push_back(transmission_of(numbers, clear));
    add(numbers.coat, numbers.coat_weight);
    return material;
}

}  // namespace burnish
