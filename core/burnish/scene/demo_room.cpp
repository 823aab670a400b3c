#include <burnish/scene/demo_room.h>
#include <burnish/scene/demo_shapes.h>

namespace burnish {
namespace {

constexpr Vec3f kLow{-3, -2.5f, 0}, kHigh{3, 3, 2.8f};  // corners of the room
constexpr float kTable = 0.72f;                         // height of its top

/// A rectangle of columns x rows cells from `corner` on, seen from the side of u x v: those cells that `has` picks.
struct Wall {
    Vec3f corner, u, v;
    int columns, rows;

    template <class Has>
    Mesh cells(const Has& has) const {
        Mesh mesh;
        const Vec3f n = u.cross(v).normalized(), t = u.normalized();
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                if (!has(i, j)) continue;
                const auto first = static_cast<uint32_t>(mesh.vertices.size());
                for (const auto& [x, y] :
                     {std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1), std::pair(i, j + 1)}) {
                    const Vec2f uv(static_cast<float>(x) / static_cast<float>(columns),
                                   static_cast<float>(y) / static_cast<float>(rows));
                    mesh.vertices.push_back({corner + u * uv.x + v * uv.y, n, t, uv});
                }
                mesh.triangles.push_back({first, first + 1, first + 2});
                mesh.triangles.push_back({first, first + 2, first + 3});
            }
        return mesh;
    }
    Mesh all() const {
        return cells([](int, int) { return true; });
    }
    Mesh checks(int parity) const {
        return cells([=](int i, int j) { return (i + j) % 2 == parity; });
    }
    Mesh stripes(int parity) const {
        return cells([=](int i, int) { return i % 2 == parity; });
    }
};

void add_walls(SceneBuilder& b) {
    const Vec3f size = kHigh - kLow, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    const Wall floor{kLow, x, y, 12, 11}, ceiling{{kLow.x, kHigh.y, kHigh.z}, x, -y, 1, 1};
    const Wall back{{kLow.x, kHigh.y, 0}, x, z, 16, 1}, front{{kHigh.x, kLow.y, 0}, -x, z, 1, 1};
    const Wall left{kLow, y, z, 1, 1}, right{{kHigh.x, kHigh.y, 0}, -y, z, 10, 5};
    b.add("floor_light", "lacquer", {0.42f, 0.36f, 0.28f}, 0.2f, floor.checks(0));
    b.add("floor_dark", "lacquer", {0.10f, 0.07f, 0.05f}, 0.2f, floor.checks(1));
    b.add("ceiling", "", {0.80f, 0.80f, 0.78f}, 1, ceiling.all());
    b.add("wall_back_light", "", {0.70f, 0.64f, 0.50f}, 1, back.stripes(0));
    b.add("wall_back_dark", "", {0.16f, 0.28f, 0.42f}, 1, back.stripes(1));
    b.add("wall_right_light", "", {0.72f, 0.70f, 0.66f}, 1, right.checks(0));
    b.add("wall_right_dark", "", {0.45f, 0.15f, 0.10f}, 1, right.checks(1));
    b.add("wall_left", "", {0.30f, 0.50f, 0.34f}, 1, left.all());
    b.add("wall_front", "", {0.70f, 0.70f, 0.70f}, 1, front.all());
}

Wall panel(float x, float y, float width, float depth) {
    return {{x - width / 2, y + depth / 2, kHigh.z - 0.02f}, {width, 0, 0}, {0, -depth, 0}, 1, 1};
}

void add_table(SceneBuilder& b) {
    const float half_x = 0.62f, half_y = 0.40f, thick = 0.02f;
    const Vec3f middle(0.25f, 0.55f, 0);
    b.add("table_top", "lacquer", {0.012f, 0.03f, 0.10f}, 0.2f,
          placed(make_box({half_x, half_y, thick}, 0.008f, 4), {middle + Vec3f(0, 0, kTable - thick)}));
    Mesh legs;
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
            const float height = kTable - 2 * thick;
            const Vec3f at = middle + Vec3f(x * (half_x - 0.06f), y * (half_y - 0.06f), height / 2);
            append(legs, placed(make_box({0.025f, 0.025f, height / 2}, 0.005f, 2), {at}));
        }
    b.add("table_legs", "brushed-steel", {0.05f, 0.05f, 0.05f}, 0.4f, std::move(legs));
    b.add("knot_gold", "gold", {0.06f, 0.04f, 0.012f}, 0.3f,
          placed(make_torus_knot(2, 3, 0.13f, 0.042f, 256, 32), {middle + Vec3f(-0.32f, 0, kTable + 0.19f), 20, 68}));
    b.add("bowl_aluminium", "brushed-aluminium", {0.05f, 0.05f, 0.052f}, 0.4f,
          placed(make_bowl(96), {middle + Vec3f(0.28f, -0.02f, kTable), 0, 0, Vec3f(0.55f)}));
}

void add_objects(SceneBuilder& b) {
    b.add("pedestal", "", {0.55f, 0.52f, 0.48f}, 0.9f,
          placed(make_box({0.24f, 0.24f, 0.4f}, 0.015f, 3), {{-0.95f, 0.9f, 0.4f}}));
    b.add("vase_chrome", "chrome", {0.03f, 0.03f, 0.03f}, 0.1f,
          placed(make_vase(128), {{-0.95f, 0.9f, 0.8f}, 0, 0, Vec3f(0.55f)}));
    b.add("ball_silver", "silver", {0.03f, 0.03f, 0.03f}, 0.2f, placed(make_sphere(0.22f, 96), {{0.95f, -0.30f, 0.22f}}));
    b.add("ball_copper", "copper", {0.06f, 0.03f, 0.02f}, 0.3f, placed(make_sphere(0.16f, 96), {{-0.50f, -0.25f, 0.16f}}));
    b.add("box_lacquer", "car-paint", {0.13f, 0.006f, 0.008f}, 0.2f,
          placed(make_box({0.24f, 0.20f, 0.34f}, 0.03f, 5), {{-2.05f, 1.35f, 0.34f}, 32}));
    b.add("ball_plastic", "plastic-gloss", {0.55f, 0.22f, 0.01f}, 0.2f,
          placed(make_sphere(0.26f, 96), {{2.45f, 1.40f, 0.26f}}));
    b.add("ring_rubber", "rubber", {0.03f, 0.10f, 0.08f}, 0.7f,
          placed(make_torus_knot(1, 0, 0.19f, 0.075f, 128, 32), {{1.35f, 1.75f, 0.075f}}));
    b.add("pane_clear", "clear-glass", {0.02f, 0.03f, 0.03f}, 0.1f,
          placed(make_box({0.42f, 0.008f, 0.62f}, 0.004f, 2), {{-1.95f, 0.35f, 0.62f}, 20}));
    b.add("pane_frosted", "frosted-glass", {0.02f, 0.03f, 0.03f}, 0.5f,
          placed(make_box({0.50f, 0.008f, 0.62f}, 0.004f, 2), {{1.60f, 0.60f, 0.62f}, -16}));
}

}  // namespace

Scene make_demo_room() {
    SceneBuilder b;
    add_walls(b);
    b.add_lamp("lamp_large", {16, 15, 13}, panel(0.3f, 0.6f, 1.4f, 0.9f).all());
    b.add_lamp("lamp_small", {22, 17, 10}, panel(-2.1f, 1.9f, 0.5f, 0.5f).all());
    add_table(b);
    add_objects(b);
    return b.take();
}

Viewpoint demo_room_viewpoint() { return {{-0.1f, -2.4f, 1.4f}, {0, 0.9f, 0.66f}, {0, 0, 1}, 76}; }

}  // namespace burnish
