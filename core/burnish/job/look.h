// What a job shows: who wears which material, and the lights, prepared once and used for every frame.
#pragma once

#include <burnish/factor/factors.h>
#include <burnish/input/frame.h>
#include <burnish/job/assign_lights.h>
#include <burnish/job/job.h>
#include <burnish/material/diffuse_reflectance.h>
#include <burnish/plan/lobe_choice.h>
#include <burnish/shading/material_shader.h>
#include <burnish/shading/predictor.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burnish {

class ColorFlow;

/// Entry i of every list belongs to rule i.
struct Wardrobe {
    std::vector<AssignRule> rules;  // the whole-frame material first, so that every other rule wins over it
    std::vector<Material> materials;
    std::vector<Material> old_materials;  // mode difference only
    std::vector<DiffuseReflectance> kd;
    /// Estimator factored: maps that were made beforehand, by the rule's material; of the old one in its place.
    std::map<std::string, Factors> factors, old_factors;
    std::vector<std::string> warnings;  // materials that create energy
};

/// Throws Error(bad_argument) when the job has no material, or one that is neither its own, a preset nor a file, and for maps that
/// nothing would read; as read_factors.
Wardrobe prepare_wardrobe(const Job& job);

/// How a material is shaded.
struct ShadingSettings {
    EstimatorSettings estimator;
    DensitySettings density;
    std::optional<LobeChoice> lobes;  // none: all

    bool is_sparse() const { return density.density == ShadingDensity::sparse; }
};

class ReadyMaterials;
class LookPlan;

/// Wardrobe and lights, ready to shade: what a frame needs is made when the first frame asks, and kept for the next.
struct Look {
    Wardrobe wardrobe;
    Rig rig;
    ShadingSettings shading;                // of the job; where it has no target, the density is settled
    int frames = 1;                         // that will use it, about: what is made once is worth more
    std::shared_ptr<ReadyMaterials> ready;  // tables of materials
    std::shared_ptr<LookPlan> plan;         // with a target only
};

/// How much there is to shade: samples of a whole frame, and frames, about.
struct Workload {
    size_t pixels = 0;
    int frames = 1;
};

Look prepare_look(const Job& job, Wardrobe wardrobe, Rig rig, const Workload& work);

/// What shades the looks of a frame: entry i belongs to look i. Predictors: where any look is sparse.
struct Equipment {
    std::vector<MaterialShader> shaders, old_shaders;
    std::vector<BandwidthPredictor> predictors, old_predictors;
};

/// Makes the tables that are not there yet. `shading`: of each look; empty = as the job says. The look must outlive the result. Not
/// thread-safe.
Equipment equip(const Look& look, const std::vector<LitRule>& looks, const std::vector<ShadingSettings>& shading = {});
/// The same for one look's material alone, without predictors.
MaterialShader equip_shader(const Look& look, const LitRule& lit, const ShadingSettings& shading);

/// The job's environment, in the frame's colour space. An up axis left to burnish is the one of the frame's renderer.
/// Throws Error(bad_argument | read_failed | color_space).
std::shared_ptr<const Environment> load_light(const Job& job, const ColorFlow& color, Renderer renderer);

/// The same from a picture in memory.
std::shared_ptr<const Environment> light_from_picture(const Job& job, const ColorFlow& color, Image picture, Renderer renderer);

}  // namespace burnish
