// A material as numbers: a diffuse colour and any number of lobes. This is what JSON holds and users edit.
#pragma once

#include <burnish/base/types.h>
#include <burnish/material/fresnel.h>

#include <memory>
#include <string>
#include <vector>

namespace burnish {

enum class ModelId {
#define BURNISH_MODEL(id, type) id,
#include <burnish/material/models/models.def>
#undef BURNISH_MODEL
};

enum class Side { reflection, transmission };

/// Which of a lobe's numbers come from layers of the frame, pixel by pixel, instead of from the lobe.
struct PerPixel {
    bool roughness = false, anisotropy = false, rotation = false, tint = false, weight = false;
};

/// What a model makes once from its numbers, or a measurement that it shows. Copies of a lobe share it.
struct LobeData {
    virtual ~LobeData() = default;
};

/// One lobe. Widths are slope widths: m = RMS slope * sqrt(2) for Beckmann and Kurt, alpha for GGX, along t (mx) and b (my).
struct LobeParameters {
    ModelId model = ModelId::kurt;
    Side side = Side::reflection;
    float strength = 1.0f;  // ks or kt, [0, inf)
    Color3f tint{1, 1, 1};
    float mx = 0.1f, my = 0.1f;  // (0, 1]
    float rotation = 0.0f;       // radians, turns t about n, right-hand rule
    Fresnel fresnel;
    std::vector<float>
        extra;  // the model's own parameters, in the order of ModelInfo::parameters; red, green, blue of a colour
    std::shared_ptr<const LobeData> data;  // of models that have any, see `prepare` (any_model.h)
    PerPixel per_pixel;

    /// Whether it may depend on the direction of the tangent.
    bool is_anisotropic() const { return mx != my || per_pixel.anisotropy; }
};

struct Material {
    std::string name;
    Color3f kd{0, 0, 0};  // diffuse reflectivity, used where burnish makes the diffuse part itself
    std::vector<LobeParameters> lobes;
    bool kd_coupled = false;              // the diffuse part has only what the lobes leave, see diffuse_reflectance.h
    std::vector<std::string> notes = {};  // what was left out of a material of another program
};

/// Slope widths of a roughness `alpha` and an artist's anisotropy a in [-1, 1], as Cycles' Anisotropic BSDF has them:
/// a >= 0: (alpha (1 - a), alpha / (1 - a)); a < 0: (alpha / (1 + a), alpha (1 + a)); both kept in [1e-4, 1].
Vec2f anisotropic_widths(float alpha, float anisotropy);

}  // namespace burnish
