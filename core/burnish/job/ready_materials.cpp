#include <burnish/job/ready_materials.h>

#include <burnish/shading/factored.h>

#include <algorithm>
#include <tuple>

namespace burnish {
namespace {

bool same(const EstimatorSettings& a, const EstimatorSettings& b) {
    const auto fields = [](const EstimatorSettings& s) {
        const auto& [kind, samples, adaptive, pattern, border, quadrature, bias, correction, tolerance, most, maps, size] = s;
        return std::tie(kind, samples, adaptive, pattern, border, quadrature, bias, correction, tolerance, most, maps, size);
    };
    return fields(a) == fields(b);
}

bool same(const DensitySettings& a, const DensitySettings& b) {
    const auto fields = [](const DensitySettings& s) {
        const auto& [density, prediction, directions, safety] = s;
        return std::tie(density, prediction, directions, safety);
    };
    return fields(a) == fields(b);
}

/// What shades or predicts under the chain: by the tables of `all` that were made so, or by new ones; `distant` makes those of the
/// environment alone.
template <class Distant, class Shared, class All, class Settings, class Make>
Distant ready(All& all, const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
              const Settings& settings, const Make& distant) {
    const bool is_distant = rig.is_distant(chain);
    auto made = std::ranges::find_if(all, [&](const auto& own) {
        return own.name == name && std::holds_alternative<Distant>(own.tables) == is_distant && same(own.settings, settings);
    });
    if (made == all.end() && is_distant) made = all.insert(made, {name, settings, distant()});
    if (made == all.end()) made = all.insert(made, {name, settings, std::make_shared<const Shared>(material, settings)});
    if (is_distant) return std::get<Distant>(made->tables);
    return Distant(std::get<std::shared_ptr<const Shared>>(made->tables), rig.chain(chain));
}

}  // namespace

MaterialShader ReadyMaterials::shader(const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
                                      const EstimatorSettings& settings, const Factors* maps) {
    return ready<MaterialShader, MaterialTaps>(m_shaders, name, material, rig, chain, settings, [&] {
        const Environment& light = *rig.environment();
        if (!maps || settings.kind != EstimatorKind::factored) return MaterialShader(material, light, settings);
        return MaterialShader(std::make_shared<const FactoredShader>(material, light, *maps));
    });
}

BandwidthPredictor ReadyMaterials::predictor(const std::string& name, const Material& material, const Rig& rig,
                                             const RigChain& chain, const DensitySettings& settings) {
    return ready<BandwidthPredictor, MaterialProbes>(m_predictors, name, material, rig, chain, settings, [&] {
        return BandwidthPredictor(material, *rig.environment(), settings);
    });
}

}  // namespace burnish
