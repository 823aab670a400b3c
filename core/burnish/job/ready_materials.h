// The tables of materials, made when pixels first wear them, and kept: by material, by how it is shaded, and by whether its light is the
// environment alone, whose tables are the material's own, or a chain of lights, which share them.
#pragma once

#include <burnish/job/look.h>
#include <burnish/shading/local_prediction.h>
#include <burnish/shading/local_shading.h>

#include <deque>
#include <string>

namespace burnish {

class ReadyMaterials {
public:
    /// What shades `material` under a chain of the rig's lights. `name` stands for the material. The rig must outlive the result.
    MaterialShader shader(const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
                          const EstimatorSettings& settings);
    BandwidthPredictor predictor(const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
                                 const DensitySettings& settings);

private:
    struct Shading {
        std::string name;
        bool is_distant;
        EstimatorSettings settings;
        std::optional<MaterialShader> distant;
        std::shared_ptr<const MaterialTaps> taps;  // under chains
    };
    struct Prediction {
        std::string name;
        bool is_distant;
        DensitySettings settings;
        std::optional<BandwidthPredictor> distant;
        std::shared_ptr<const MaterialProbes> probes;  // under chains
    };

    std::deque<Shading> m_shading;
    std::deque<Prediction> m_predictions;
};

}  // namespace burnish
