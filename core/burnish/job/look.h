// What a job shows: who wears which material, and the light, prepared once and used for every frame.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/job/job.h>
#include <burnish/shading/material_shader.h>
#include <burnish/shading/predictor.h>

#include <memory>
#include <string>
#include <vector>

namespace burnish {

class ColorFlow;

/// Entry i of every list belongs to rule i.
struct Wardrobe {
    std::vector<AssignRule> rules;  // the whole-frame material first, so that every other rule wins over it
    std::vector<Material> materials;
    std::vector<Material> old_materials;  // mode difference only
    std::vector<Color3f> kd;
    std::vector<std::string> warnings;  // materials that create energy
};

/// Throws Error(bad_argument) when the job has no material, or one that is neither its own, a preset nor a file.
Wardrobe prepare_wardrobe(const Job& job);

/// Wardrobe and light, ready to shade.
struct Look {
    Wardrobe wardrobe;
    std::shared_ptr<const Environment> light;
    std::vector<MaterialShader> shaders, old_shaders;
    std::vector<BandwidthPredictor> predictors, old_predictors;  // sparse shading only
};

Look prepare_look(const Job& job, Wardrobe wardrobe, std::shared_ptr<const Environment> light);

/// The job's environment, in the frame's colour space. An up axis left to burnish is the one of the frame's renderer.
/// Throws Error(bad_argument | read_failed | color_space).
std::shared_ptr<const Environment> load_light(const Job& job, const ColorFlow& color, Renderer renderer);

/// The same from a picture in memory.
std::shared_ptr<const Environment> light_from_picture(const Job& job, const ColorFlow& color, Image picture, Renderer renderer);

}  // namespace burnish
