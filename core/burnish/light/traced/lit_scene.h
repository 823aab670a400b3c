// A scene file with its light, ready to be traced: geometry, light maps and lamps in one.
#pragma once

#include <burnish/light/light_settings.h>
#include <burnish/light/traced/lamps.h>

#include <Imath/ImathBox.h>

#include <algorithm>
#include <functional>

namespace burnish {

class LitScene {
public:
    /// Reads the scene and its maps. `convert` takes RGB into the colour space of the work; empty = it is there. What is not a
    /// finite number >= 0 in a map counts as 0. Throws Error(read_failed | bad_argument), the latter too for a scene without light.
    LitScene(const TracedSettings& settings, const std::function<void(Image&)>& convert = {});
    /// From memory.
    LitScene(Scene scene, LightMaps maps);
    LitScene(const LitScene&) = delete;
    LitScene& operator=(const LitScene&) = delete;

    const Tracer& tracer() const { return m_tracer; }
    const SurfaceLight& light() const { return m_light; }
    const Lamps& lamps() const { return m_lamps; }
    /// About all of it, scene units.
    const Imath::Box3f& box() const { return m_box; }
    /// Largest edge of the box.
    float extent() const { return m_box.isEmpty() ? 0 : std::max({m_box.size().x, m_box.size().y, m_box.size().z}); }

private:
    Scene m_scene;
    Tracer m_tracer;
    SurfaceLight m_light;
    Lamps m_lamps;
    Imath::Box3f m_box;
};

}  // namespace burnish
