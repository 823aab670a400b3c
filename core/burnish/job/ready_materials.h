// The tables of materials, made when pixels first wear them, and kept: by material, by how it is shaded, and by whether its light is the
// environment alone, whose tables are the material's own, or a chain of lights, which share them.
#pragma once

#include <burnish/job/look.h>
#include <burnish/shading/local_prediction.h>
#include <burnish/shading/local_shading.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace burnish {

class ReadyMaterials {
public:
    /// What shades `material` under a chain of the rig's lights. `name` stands for the material. `maps`: for `factored`, null = to be
    /// made. The rig must outlive the result. Throws as MaterialShader and MaterialTaps.
    MaterialShader shader(const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
                          const EstimatorSettings& settings, const Factors* maps = nullptr);
    BandwidthPredictor predictor(const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
                                 const DensitySettings& settings);

private:
    /// What was made for a name and settings: tables of the environment alone, or tables that chains share.
    template <class Settings, class Distant, class Shared>
    struct Made {
        std::string name;
        Settings settings;
        std::variant<Distant, std::shared_ptr<const Shared>> tables;
    };

    std::vector<Made<EstimatorSettings, MaterialShader, MaterialTaps>> m_shaders;
    std::vector<Made<DensitySettings, BandwidthPredictor, MaterialProbes>> m_predictors;
};

}  // namespace burnish
