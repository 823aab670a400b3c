#include <burnish/job/rig.h>

namespace burnish {

const Environment* Rig::environment() const {
    return has_environment() ? &std::get<EnvironmentLight>(*lights.back().light).environment() : nullptr;
}

LightChain Rig::chain(const RigChain& places) const {
    std::vector<LightChain::Link> links;
    for (const size_t place : places) links.push_back({lights[place].light, lights[place].blocks});
    return LightChain(std::move(links));
}

}  // namespace burnish
