#include <burnish/job/rig.h>

namespace burnish {

const Environment* Rig::environment() const {
    return has_environment() ? &std::get<EnvironmentLight>(*lights.back().slot->light()).environment() : nullptr;
}

LightChain Rig::chain(const RigChain& places) const {
    std::vector<LightChain::Link> links;
    for (const size_t place : places) links.push_back({lights[place].slot->light(), lights[place].blocks});
    return LightChain(std::move(links));
}

size_t Rig::loaded_count() const {
    return static_cast<size_t>(
        std::ranges::count_if(lights, [](const RigLight& light) { return light.slot && light.slot->is_loaded(); }));
}

LightNotes Rig::told() const {
    LightNotes all;
    for (const RigLight& light : lights) {
        const LightNotes own = light.slot ? light.slot->told() : LightNotes();
        all.notes.insert(all.notes.end(), own.notes.begin(), own.notes.end());
        all.warnings.insert(all.warnings.end(), own.warnings.begin(), own.warnings.end());
    }
    return all;
}

}  // namespace burnish
