#include <burnish/job/ready_materials.h>

#include <algorithm>
#include <tuple>

namespace burnish {
namespace {

bool same(const EstimatorSettings& a, const EstimatorSettings& b) {
    const auto fields = [](const EstimatorSettings& s) {
        const auto& [kind, samples, adaptive, pattern, border, quadrature, bias, correction, tolerance, most] = s;
        return std::tie(kind, samples, adaptive, pattern, border, quadrature, bias, correction, tolerance, most);
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

/// The entry of these, made by `make` where there is none.
template <class Entries, class Settings, class Make>
auto& entry_of(Entries& entries, const std::string& name, bool is_distant, const Settings& settings, Make&& make) {
    const auto found = std::ranges::find_if(
        entries, [&](const auto& e) { return e.name == name && e.is_distant == is_distant && same(e.settings, settings); });
    if (found != entries.end()) return *found;
    auto& entry = entries.emplace_back(name, is_distant, settings, std::nullopt, nullptr);
    make(entry);
    return entry;
}

}  // namespace

MaterialShader ReadyMaterials::shader(const std::string& name, const Material& material, const Rig& rig, const RigChain& chain,
                                      const EstimatorSettings& settings) {
    const bool is_distant = rig.is_distant(chain);
    const Shading& ready = entry_of(m_shading, name, is_distant, settings, [&](Shading& own) {
        if (is_distant)
            own.distant.emplace(material, *rig.environment(), settings);
        else
            own.taps = std::make_shared<const MaterialTaps>(material, settings);
    });
    return is_distant ? *ready.distant : MaterialShader(ready.taps, rig.chain(chain));
}

BandwidthPredictor ReadyMaterials::predictor(const std::string& name, const Material& material, const Rig& rig,
                                             const RigChain& chain, const DensitySettings& settings) {
    const bool is_distant = rig.is_distant(chain);
    const Prediction& ready = entry_of(m_predictions, name, is_distant, settings, [&](Prediction& own) {
        if (is_distant)
            own.distant.emplace(material, *rig.environment(), settings);
        else
            own.probes = std::make_shared<const MaterialProbes>(material, settings);
    });
    return is_distant ? *ready.distant : BandwidthPredictor(ready.probes, rig.chain(chain));
}

}  // namespace burnish
