// Meshes: closed, oriented outwards, with normals that belong to the surface.
#include <burnish/scene/mesh.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace burnish {
namespace {

Vec3f corner(const Mesh& mesh, size_t triangle, size_t k) { return mesh.vertices[mesh.triangles[triangle][k]].p; }

/// Volume by the divergence theorem; right only for closed meshes whose triangles turn outwards.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        sum += corner(mesh, i, 0).dot(corner(mesh, i, 1).cross(corner(mesh, i, 2))) / 6;
    return sum;
}

/// Smallest cosine between a triangle's own normal and its vertices' normals; slivers at poles are left out.
float worst_normal(const Mesh& mesh) {
    float worst = 1;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3f a = corner(mesh, i, 0), n = (corner(mesh, i, 1) - a).cross(corner(mesh, i, 2) - a);
        if (n.length() < 1e-9f) continue;
        for (const uint32_t vertex : mesh.triangles[i]) worst = std::min(worst, n.normalized().dot(mesh.vertices[vertex].n));
    }
    return worst;
}

void expect_unit_frames(const Mesh& mesh) {
    for (const Vertex& vertex : mesh.vertices) {
        ASSERT_NEAR(vertex.n.length(), 1, 1e-5);
        ASSERT_NEAR(vertex.t.length(), 1, 1e-5);
        ASSERT_NEAR(vertex.n.dot(vertex.t), 0, 1e-3);
    }
}

const Vec2f kRing[] = {{1.25f, 0}, {1, 0.25f}, {0.75f, 0}, {1, -0.25f}};

TEST(Mesh, SphereHasItsVolumeAndNormals) {
    const Mesh sphere = make_sphere(2, 256);
    EXPECT_NEAR(volume(sphere), 4.0 / 3 * kPi * 8, 0.01);
    EXPECT_GT(worst_normal(sphere), 0.999f);
    expect_unit_frames(sphere);
    for (const Vertex& vertex : sphere.vertices) ASSERT_NEAR((vertex.p / 2 - vertex.n).length(), 0, 1e-6);
}

TEST(Mesh, BoxWithBevelHasTheVolumeOfABoxSweptByABall) {
    const Vec3f half(1.0f, 0.5f, 0.75f);
    const float r = 0.1f;
    const Vec3f inner = (half - Vec3f(r)) * 2;
    const double expected = inner.x * inner.y * inner.z + 2 * r * (inner.x * inner.y + inner.y * inner.z + inner.z * inner.x) +
                            kPi * r * r * (inner.x + inner.y + inner.z) + 4.0 / 3 * kPi * r * r * r;
    const Mesh box = make_box(half, r, 16);
    EXPECT_NEAR(volume(box), expected, 1e-3 * expected);
    EXPECT_GT(worst_normal(box), 0.99f);
    expect_unit_frames(box);
}

TEST(Mesh, ClosedLatheHasTheVolumeOfItsRing) {
    // A circle through four points by Catmull-Rom is close to, not on, the circle: compare with Pappus on the curve's own area.
    const Mesh ring = make_lathe(kRing, true, 256, 256);
    double area = 0;
    for (int j = 0; j < 256; ++j) {
        const Vec3f a = ring.vertices[static_cast<size_t>(j) * 257].p, b = ring.vertices[static_cast<size_t>(j + 1) * 257].p;
        area += 0.5 * ((a.x - 1) * b.z - (b.x - 1) * a.z);
    }
    EXPECT_NEAR(volume(ring), 2 * kPi * area, 1e-3);
    EXPECT_GT(worst_normal(ring), 0.999f);
    expect_unit_frames(ring);
}

TEST(Mesh, LatheTangentRunsAroundTheAxis) {
    for (const Vertex& vertex : make_lathe(kRing, true, 64, 64).vertices) {
        ASSERT_NEAR(vertex.t.z, 0, 1e-6);
        ASSERT_NEAR(vertex.t.dot(Vec3f(vertex.p.x, vertex.p.y, 0)), 0, 1e-5);
    }
}

TEST(Mesh, TorusIsAKnotThatWindsOnce) {
    const Mesh torus = make_torus_knot(1, 0, 1, 0.25f, 512, 128);
    EXPECT_NEAR(volume(torus), 2 * kPi * kPi * 0.0625, 2e-3);
    EXPECT_GT(worst_normal(torus), 0.999f);
    expect_unit_frames(torus);
}

TEST(Mesh, KnotHasTheVolumeOfItsTube) {
    const Mesh knot = make_torus_knot(2, 3, 1, 0.1f, 2048, 64);
    double length = 0;
    const size_t rings = 2048, stride = 65;
    const auto centre = [&](size_t ring) {
        Vec3f sum(0.0f);
        for (size_t i = 0; i + 1 < stride; ++i) sum += knot.vertices[ring * stride + i].p;
        return sum / static_cast<float>(stride - 1);
    };
    for (size_t ring = 0; ring < rings; ++ring) length += (centre(ring + 1) - centre(ring)).length();
    EXPECT_NEAR(volume(knot), length * kPi * 0.01, 2e-3 * length * kPi * 0.01);
    EXPECT_GT(worst_normal(knot), 0.995f);
    expect_unit_frames(knot);
}

TEST(Mesh, TransformedNormalsStayPerpendicularToAStretchedSurface) {
    Matrix44f stretch;
    stretch.setScale(Vec3f(3, 1, 0.5f));
    const Mesh mesh = transformed(make_sphere(1, 256), stretch);
    EXPECT_GT(worst_normal(mesh), 0.995f);
    expect_unit_frames(mesh);
}

}  // namespace
}  // namespace burnish
