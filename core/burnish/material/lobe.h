// From a lobe's numbers to its value type: one dispatch per batch, after which everything inlines.
#pragma once

#include <burnish/material/any_model.h>
#include <burnish/material/model.h>
#include <burnish/material/models/beckmann.h>
#include <burnish/material/models/ggx.h>
#include <burnish/material/models/kurt.h>

namespace burnish {

/// A transmission lobe through a thin sheet: the model with directions mirrored at the surface plane and Fresnel 1 - F.
/// Lets kernels treat both sides alike: `side_sign` is the sign of wi.z.
template <LobeKernel M>
struct Lobe {
    M model;
    float side_sign;

    Vec3f mirrored(const Vec3f& wi) const { return {wi.x, wi.y, wi.z * side_sign}; }
    Color3f eval(const Vec3f& wo, const Vec3f& wi) const { return model.eval(wo, mirrored(wi)); }
    float pdf(const Vec3f& wo, const Vec3f& wi) const { return model.pdf(wo, mirrored(wi)); }
    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return mirrored(model.sample(wo, u)); }
    float D(const Vec3f& wm) const { return model.D(wm); }
    float border(float xi0) const { return model.border(xi0); }
    Lobe with_widths(float mx, float my) const { return {model.with_widths(mx, my), side_sign}; }
    /// This lobe, which has the widths mx and my, seen through Gaussian slopes: of widths sqrt(m^2 + variance).
    Lobe blurred(float mx, float my, const Vec2f& variance) const {
        if constexpr (requires { model.blurred(variance); }) return {model.blurred(variance), side_sign};
        return with_widths(std::sqrt(mx * mx + variance.x), std::sqrt(my * my + variance.y));
    }
};

/// Calls `visit(Lobe<M>)` with the lobe's own model type, AnyModel for the ones that kernels are not compiled for.
template <class Visitor>
decltype(auto) visit_lobe(const LobeParameters& p, Visitor&& visit) {
    const float side_sign = p.side == Side::transmission ? -1.0f : 1.0f;
    switch (p.model) {
#define BURNISH_ERASED_MODEL(id, type)
#define BURNISH_MODEL(id, type) \
    case ModelId::id:           \
        return visit(Lobe<type>{type(p), side_sign});
#include <burnish/material/models/models.def>
#undef BURNISH_MODEL
        default: break;
    }
    return visit(Lobe<AnyModel>{AnyModel(p), side_sign});
}

}  // namespace burnish
