#include <burnish/job/rig.h>

#include <algorithm>

namespace burnish {

const Environment* Rig::environment() const {
    return has_environment() ? &std::get<EnvironmentLight>(*lights.back().light).environment() : nullptr;
}

LightChain Rig::chain(const RigChain& places) const {
    std::vector<LightChain::Link> links;
    for (const size_t place : places) links.push_back({lights[place].light, lights[place].blocks});
    return LightChain(std::move(links));
}

PossibleLight possible_light(const Rig& rig, size_t rule) {
    const std::optional<RigChain>& chain = rig.chains[rule];
    if (chain) return {rig.is_distant(*chain), !rig.is_distant(*chain)};
    const bool alone = rig.has_environment() && rig.lights.size() == 1;
    const bool has_gaps = std::all_of(rig.lights.begin(), rig.lights.end(),
                                      [](const RigLight& light) { return !light.settings || light.as<MirrorSettings>(); });
    return {rig.has_environment() && has_gaps, !alone};
}

}  // namespace burnish
