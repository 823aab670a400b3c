#include <burnish/scene/demo_scene.h>
#include <burnish/scene/procedural_sky.h>

#include <algorithm>

namespace burnish {
namespace {

/// Scaled, then turned about Z, then tipped about X (degrees), then moved.
struct Placement {
    Vec3f position;
    float turn_deg = 0, tip_deg = 0;
    Vec3f scale{1.0f};
};

Mesh placed(Mesh mesh, const Placement& at) {
    const float degree = kPi / 180;
    Matrix44f m, rotation;
    m.setScale(at.scale);
    rotation.setEulerAngles(Vec3f(at.tip_deg, 0, at.turn_deg) * degree);
    Matrix44f translation;
    translation.setTranslation(at.position);
    return transformed(std::move(mesh), m * rotation * translation);
}

Mesh vase() {
    const Vec2f profile[] = {{0, 0},          {0.19f, 0},     {0.25f, 0.015f}, {0.31f, 0.18f}, {0.36f, 0.48f},  {0.33f, 0.80f},
                             {0.22f, 1.08f},  {0.13f, 1.32f}, {0.13f, 1.48f},  {0.20f, 1.62f}, {0.217f, 1.64f}, {0.20f, 1.645f},
                             {0.105f, 1.48f}, {0.10f, 1.32f}, {0.10f, 1.1f},   {0, 1.0f}};
    return make_lathe(profile, false, 256, 320);
}

Mesh bowl() {
    const Vec2f profile[] = {{0, 0.03f},     {0.15f, 0.02f}, {0.17f, 0},       {0.19f, 0.02f},  {0.27f, 0.08f},
                             {0.37f, 0.19f}, {0.42f, 0.33f}, {0.425f, 0.345f}, {0.415f, 0.35f}, {0.405f, 0.34f},
                             {0.35f, 0.20f}, {0.25f, 0.10f}, {0.12f, 0.06f},   {0, 0.055f}};
    return make_lathe(profile, false, 256, 320);
}

class Builder {
public:
    void add(const std::string& name, const std::string& material, const Color3f& albedo, float roughness, Mesh mesh) {
        auto known = std::find(m_materials.begin(), m_materials.end(), material);
        if (known == m_materials.end()) known = m_materials.insert(m_materials.end(), material);
        const int index = static_cast<int>(m_scene.objects.size()) + 1;
        const int material_index = static_cast<int>(known - m_materials.begin()) + 1;
        m_scene.objects.push_back({name, material, std::move(mesh), index, material_index, albedo, roughness});
    }
    Scene take() { return std::move(m_scene); }

private:
    Scene m_scene;
    std::vector<std::string> m_materials;
};

}  // namespace

Scene make_demo_scene() {
    Builder b;
    b.add("ground", "", ProceduralSky::ground_albedo(), 1.0f, make_plane(80, 80));
    b.add("car_body", "car-paint", {0.13f, 0.006f, 0.008f}, 0.3f,
          placed(make_sphere(0.85f, 384), {{-0.72f, 0.75f, 0.66f}, 12, 0, {1.3f, 1.05f, 0.78f}}));
    b.add("ball_chrome", "chrome", {0.03f, 0.03f, 0.03f}, 0.1f, placed(make_sphere(0.40f, 256), {{-1.62f, -0.85f, 0.40f}}));
    b.add("knot_gold", "gold", {0.06f, 0.04f, 0.012f}, 0.3f,
          placed(make_torus_knot(2, 3, 0.30f, 0.095f, 512, 64), {{0.12f, -0.75f, 0.42f}, 20, 68}));
    b.add("vase_aluminium", "brushed-aluminium", {0.05f, 0.05f, 0.052f}, 0.4f, placed(vase(), {{1.02f, 0.55f, 0}}));
    b.add("bowl_porcelain", "porcelain", {0.60f, 0.58f, 0.54f}, 0.2f, placed(bowl(), {{1.05f, -0.95f, 0}}));
    b.add("box_lacquer", "lacquer", {0.012f, 0.03f, 0.10f}, 0.2f,
          placed(make_box({0.36f, 0.30f, 0.26f}, 0.04f, 8), {{2.02f, 0.20f, 0.26f}, 32}));
    b.add("ball_copper", "copper", {0.06f, 0.03f, 0.02f}, 0.3f, placed(make_sphere(0.17f, 192), {{-0.62f, -1.35f, 0.17f}}));
    b.add("ball_plastic", "plastic-gloss", {0.55f, 0.22f, 0.01f}, 0.2f,
          placed(make_sphere(0.20f, 192), {{1.86f, -0.98f, 0.20f}}));
    b.add("ring_rubber", "rubber", {0.03f, 0.10f, 0.08f}, 0.7f,
          placed(make_torus_knot(1, 0, 0.19f, 0.075f, 256, 64), {{0.42f, -1.55f, 0.075f}}));
    b.add("pane_glass", "frosted-glass", {0.03f, 0.06f, 0.06f}, 0.5f,
          placed(make_box({0.42f, 0.02f, 0.80f}, 0.012f, 4), {{-2.05f, 1.0f, 0.80f}, 24}));
    return b.take();
}

Viewpoint demo_viewpoint() { return {{0, -7.2f, 1.45f}, {0.05f, 0, 0.72f}, {0, 0, 1}, 38}; }

}  // namespace burnish
