// The registry of reflectance models: models.def has one line a model, models/<name>.h holds it.
//
// A model is a value type in the local frame (z = n), free of tint and strength, that meets `LobeModel`. Kernels are
// templates over it; dispatch happens once per batch (see lobe.h), so the pixel loop inlines. Models that are there to be
// fitted and compared go through one type with virtual calls, AnyModel, so that each does not cost a copy of all kernels.
#pragma once

#include <burnish/material/parameters.h>

#include <concepts>
#include <span>
#include <string_view>
#include <vector>

namespace burnish {

/// A number a model has beyond the ones all lobes share.
struct ModelParameter {
    std::string_view name;
    float value, min, max;  // default and allowed range
    std::string_view help;
    bool per_channel = false;  // a colour: three numbers of LobeParameters::extra
};

struct ModelInfo {
    std::string_view name, summary, source;  // source: publication and equations
    std::vector<ModelParameter> parameters;  // order of LobeParameters::extra
    bool reciprocal = true;                  // f(wo, wi) == f(wi, wo)
    bool anisotropic = true;                 // mx and my may differ
    bool own_width = false;                  // its width follows from its parameters or data; another one stretches its slopes
};

/// All parameters at their defaults, as LobeParameters::extra holds them.
std::vector<float> default_parameters(const ModelInfo& model);

/// What kernels ask of a lobe. `eval` is the BRDF f in 1/sr with Fresnel; `pdf` is the density of `sample` in solid angle
/// of wi; both take unit vectors and return 0 where wo or wi is not above the surface. `sample` may return a direction
/// below the surface, which contributes nothing. `D` is the microfacet density of wm in 1/sr; `border(xi)` the normalised
/// slope tan(theta)/m beyond which the share xi of the slope distribution lies: sqrt(-ln xi) for Beckmann. `with_widths` is
/// the same lobe at another roughness.
template <class M>
concept LobeKernel = requires(const M m, Vec3f w, Vec2f u, float x) {
    { m.with_widths(x, x) } -> std::same_as<M>;
    { m.eval(w, w) } -> std::same_as<Color3f>;
    { m.pdf(w, w) } -> std::same_as<float>;
    { m.sample(w, u) } -> std::same_as<Vec3f>;
    { m.D(w) } -> std::same_as<float>;
    { m.border(x) } -> std::same_as<float>;
};

/// A type of models.def: a kernel made from a lobe's numbers that can tell about itself.
template <class M>
concept LobeModel = LobeKernel<M> && requires(const LobeParameters p) {
    { M::info() } -> std::same_as<ModelInfo>;
    M(p);
};

/// All models, in the order of models.def, which is also the order of ModelId.
std::span<const ModelInfo> models();
const ModelInfo& model_info(ModelId id);
/// Throws Error(bad_argument) with the known names and the nearest one.
ModelId model_by_name(std::string_view name);

}  // namespace burnish
