// The lights of a job, ready to shine, and which of them each rule may use.
#pragma once

#include <burnish/job/light_slot.h>
#include <burnish/light/light_chain.h>
#include <burnish/light/light_settings.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burnish {

struct RigLight {
    std::string name;
    std::optional<LightSettings> settings;  // none: the environment
    std::shared_ptr<LightSlot> slot;        // null: its file is another one for each frame, and no frame has come yet
    bool blocks = true;

    template <class Kind>
    const Kind* as() const {
        return settings ? std::get_if<Kind>(&settings->kind) : nullptr;
    }
};

/// Places in Rig::lights, the light in front first.
using RigChain = std::vector<size_t>;

struct Rig {
    std::vector<RigLight> lights;                 // by name, the environment last; those that no rule can use are not there
    std::vector<std::optional<RigChain>> chains;  // of each rule; none: chosen by place, see assign_lights.h

    bool has_environment() const { return !lights.empty() && !lights.back().settings; }
    /// Null when there is none.
    const Environment* environment() const;
    /// Whether the chain is the environment and nothing else.
    bool is_distant(const RigChain& chain) const {
        return chain.size() == 1 && has_environment() && chain[0] + 1 == lights.size();
    }
    /// Loads what is not loaded yet.
    LightChain chain(const RigChain& places) const;
    size_t loaded_count() const;
    /// Of the lights loaded so far, in their order.
    LightNotes told() const;
};

}  // namespace burnish
