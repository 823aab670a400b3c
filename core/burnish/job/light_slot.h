// A light that is loaded when a pixel first needs it: rigs name more lights than most frames see.
#pragma once

#include <burnish/light/light.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace burnish {

/// What lights have to tell.
struct LightNotes {
    std::vector<std::string> notes, warnings;
};

class LightSlot {
public:
    using Load = std::function<Light(LightNotes& told)>;

    explicit LightSlot(Load load) : m_load(std::move(load)) {}
    LightSlot(Light light, LightNotes told)
        : m_told(std::move(told)), m_light(std::make_shared<const Light>(std::move(light))) {}

    /// Loads it once, whoever asks first. Throws what loading throws.
    std::shared_ptr<const Light> light() {
        const std::lock_guard lock(m_loading);
        if (!m_light) m_light = std::make_shared<const Light>(m_load(m_told));
        return m_light;
    }
    bool is_loaded() const {
        const std::lock_guard lock(m_loading);
        return m_light != nullptr;
    }
    /// Empty before it is loaded.
    LightNotes told() const {
        const std::lock_guard lock(m_loading);
        return m_light ? m_told : LightNotes();
    }

private:
    mutable std::mutex m_loading;
    Load m_load;
    LightNotes m_told;
    std::shared_ptr<const Light> m_light;
};

}  // namespace burnish
