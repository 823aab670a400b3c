#include <burnish/scene/demo_shapes.h>

#include <algorithm>

namespace burnish {

Mesh placed(Mesh mesh, const Placement& at) {
    const float degree = kPi / 180;
    Matrix44f m, rotation;
    m.setScale(at.scale);
    rotation.setEulerAngles(Vec3f(at.tip_deg, 0, at.turn_deg) * degree);
    Matrix44f translation;
    translation.setTranslation(at.position);
    return transformed(std::move(mesh), m * rotation * translation);
}

Mesh make_vase(int segments) {
    const Vec2f profile[] = {{0, 0},          {0.19f, 0},     {0.25f, 0.015f}, {0.31f, 0.18f}, {0.36f, 0.48f},  {0.33f, 0.80f},
                             {0.22f, 1.08f},  {0.13f, 1.32f}, {0.13f, 1.48f},  {0.20f, 1.62f}, {0.217f, 1.64f}, {0.20f, 1.645f},
                             {0.105f, 1.48f}, {0.10f, 1.32f}, {0.10f, 1.1f},   {0, 1.0f}};
    return make_lathe(profile, false, segments, segments * 5 / 4);
}

Mesh make_bowl(int segments) {
    const Vec2f profile[] = {{0, 0.03f},     {0.15f, 0.02f}, {0.17f, 0},       {0.19f, 0.02f},  {0.27f, 0.08f},
                             {0.37f, 0.19f}, {0.42f, 0.33f}, {0.425f, 0.345f}, {0.415f, 0.35f}, {0.405f, 0.34f},
                             {0.35f, 0.20f}, {0.25f, 0.10f}, {0.12f, 0.06f},   {0, 0.055f}};
    return make_lathe(profile, false, segments, segments * 5 / 4);
}

void SceneBuilder::add(const std::string& name, const std::string& material, const Color3f& albedo, float roughness,
                       Mesh mesh) {
    auto known = std::find(m_materials.begin(), m_materials.end(), material);
    if (known == m_materials.end()) known = m_materials.insert(m_materials.end(), material);
    const int index = static_cast<int>(m_scene.objects.size()) + 1;
    const int material_index = static_cast<int>(known - m_materials.begin()) + 1;
    m_scene.objects.push_back({name, material, std::move(mesh), index, material_index, albedo, roughness});
}

void SceneBuilder::add_lamp(const std::string& name, const Color3f& emission, Mesh mesh) {
    add(name, "lamp", Color3f(0.0f), 1, std::move(mesh));
    m_scene.objects.back().emission = emission;
}

}  // namespace burnish
