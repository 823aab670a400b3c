// What the demos' scenes are put together from. Internal: shapes by formula, and a builder that counts indices.
#pragma once

#include <burnish/scene/scene.h>

namespace burnish {

/// Scaled, then turned about Z, then tipped about X (degrees), then moved.
struct Placement {
    Vec3f position;
    float turn_deg = 0, tip_deg = 0;
    Vec3f scale{1.0f};
};
Mesh placed(Mesh mesh, const Placement& at);

/// 1.65 high, standing on z = 0; `segments` around, five quarters as many along.
Mesh make_vase(int segments);
/// 0.85 across, standing on z = 0.
Mesh make_bowl(int segments);

/// Objects with indices from 1 on; those that share a material share its index. The first object's material is 1.
class SceneBuilder {
public:
    void add(const std::string& name, const std::string& material, const Color3f& albedo, float roughness, Mesh mesh);
    /// A surface that shines on its front.
    void add_lamp(const std::string& name, const Color3f& emission, Mesh mesh);
    Scene take() { return std::move(m_scene); }

private:
    Scene m_scene;
    std::vector<std::string> m_materials;
};

}  // namespace burnish
