#include <burnish/scene/demo_scene.h>
#include <burnish/scene/demo_shapes.h>
#include <burnish/scene/procedural_sky.h>

namespace burnish {

Scene make_demo_scene() {
    SceneBuilder b;
    b.add("ground", "", ProceduralSky::ground_albedo(), 1.0f, make_plane(80, 80));
    b.add("car_body", "car-paint", {0.13f, 0.006f, 0.008f}, 0.3f,
          placed(make_sphere(0.85f, 384), {{-0.72f, 0.75f, 0.66f}, 12, 0, {1.3f, 1.05f, 0.78f}}));
    b.add("ball_chrome", "chrome", {0.03f, 0.03f, 0.03f}, 0.1f, placed(make_sphere(0.40f, 256), {{-1.62f, -0.85f, 0.40f}}));
    b.add("knot_gold", "gold", {0.06f, 0.04f, 0.012f}, 0.3f,
          placed(make_torus_knot(2, 3, 0.30f, 0.095f, 512, 64), {{0.12f, -0.75f, 0.42f}, 20, 68}));
    b.add("vase_aluminium", "brushed-aluminium", {0.05f, 0.05f, 0.052f}, 0.4f, placed(make_vase(256), {{1.02f, 0.55f, 0}}));
    b.add("bowl_porcelain", "porcelain", {0.60f, 0.58f, 0.54f}, 0.2f, placed(make_bowl(256), {{1.05f, -0.95f, 0}}));
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
