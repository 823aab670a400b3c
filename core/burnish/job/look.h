// What a job shows: who wears which material, and the lights, prepared once and used for every frame.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/job/assign_lights.h>
#include <burnish/job/job.h>
#include <burnish/material/diffuse_reflectance.h>
#include <burnish/shading/local_prediction.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>
#include <burnish/shading/predictor.h>

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
    std::vector<std::string> warnings;  // materials that create energy
};

/// Throws Error(bad_argument) when the job has no material, or one that is neither its own, a preset nor a file.
Wardrobe prepare_wardrobe(const Job& job);

/// A material ready for light: for the environment alone, whose tables are its own, and for chains of lights, which share theirs.
/// What no pixel of the material can come to lie under is empty.
struct ReadyMaterial {
    std::optional<MaterialShader> distant;
    std::optional<BandwidthPredictor> distant_predictor;  // sparse shading only
    std::shared_ptr<const MaterialTaps> taps;
    std::shared_ptr<const MaterialProbes> probes;  // sparse shading only
};

/// Wardrobe and lights, ready to shade. Entry i of the lists belongs to rule i; rules of one material share it.
struct Look {
    Wardrobe wardrobe;
    Rig rig;
    std::vector<std::shared_ptr<const ReadyMaterial>> materials, old_materials;
};

Look prepare_look(const Job& job, Wardrobe wardrobe, Rig rig);

/// What shades the looks of a frame: entry i belongs to look i. Predictors: sparse shading only.
struct Equipment {
    std::vector<MaterialShader> shaders, old_shaders;
    std::vector<BandwidthPredictor> predictors, old_predictors;
};

/// Cheap: tables are those of the materials. The look must outlive the result.
Equipment equip(const Look& look, const std::vector<LitRule>& looks);

/// The job's environment, in the frame's colour space. An up axis left to burnish is the one of the frame's renderer.
/// Throws Error(bad_argument | read_failed | color_space).
std::shared_ptr<const Environment> load_light(const Job& job, const ColorFlow& color, Renderer renderer);

/// The same from a picture in memory.
std::shared_ptr<const Environment> light_from_picture(const Job& job, const ColorFlow& color, Image picture, Renderer renderer);

}  // namespace burnish
