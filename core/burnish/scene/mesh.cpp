#include <burnish/scene/mesh.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kTwoPi = 2 * kPi;

Vec3f around_z(float radius, float z, float phi) { return {radius * std::cos(phi), radius * std::sin(phi), z}; }

/// Point and derivative of the Catmull-Rom curve through `points` at s in [0, 1]; open ends repeat the last chord.
struct CurvePoint {
    Vec2f p, dp;
};
CurvePoint catmull_rom(std::span<const Vec2f> points, bool closed, float s) {
    const int count = static_cast<int>(points.size()), spans = closed ? count : count - 1;
    const float x = s * static_cast<float>(spans);
    const int i = std::clamp(static_cast<int>(x), 0, spans - 1);
    const float f = x - static_cast<float>(i);
    const auto at = [&](int k) {
        if (closed) return points[static_cast<size_t>((k + count) % count)];
        if (k < 0) return points[0] * 2.0f - points[1];
        if (k >= count) return points[static_cast<size_t>(count - 1)] * 2.0f - points[static_cast<size_t>(count - 2)];
        return points[static_cast<size_t>(k)];
    };
    const Vec2f a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    const Vec2f c1 = (c - a) * 0.5f, c2 = a - b * 2.5f + c * 2.0f - d * 0.5f, c3 = (d - a) * 0.5f + (b - c) * 1.5f;
    return {b + (c1 + (c2 + c3 * f) * f) * f, c1 + (c2 * 2.0f + c3 * (3 * f)) * f};
}

/// Grid positions across one side of a bevelled box: which inner corner (-1, +1), and the slope of the rounding there.
std::vector<Vec2f> bevel_profile(int steps) {
    std::vector<Vec2f> profile;
    for (const float side : {-1.0f, 1.0f})
        for (int i = 0; i <= steps; ++i) {
            const float k = static_cast<float>(i) / static_cast<float>(steps);
            profile.push_back({side, std::tan(kPi / 4 * (side < 0 ? k - 1 : k))});
        }
    return profile;
}

}  // namespace

void append(Mesh& mesh, const Mesh& part) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
}

Mesh make_surface(int columns, int rows, const std::function<Vertex(float u, float v)>& surface) {
    Mesh mesh;
    mesh.vertices.reserve(static_cast<size_t>(columns + 1) * (rows + 1));
    mesh.triangles.reserve(static_cast<size_t>(columns) * rows * 2);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const Vec2f uv{static_cast<float>(i) / static_cast<float>(columns),
                           static_cast<float>(j) / static_cast<float>(rows)};
            mesh.vertices.push_back(surface(uv.x, uv.y));
            mesh.vertices.back().uv = uv;
        }
    const auto stride = static_cast<uint32_t>(columns + 1);
    for (uint32_t j = 0; j < static_cast<uint32_t>(rows); ++j)
        for (uint32_t i = 0; i < static_cast<uint32_t>(columns); ++i) {
            const uint32_t a = j * stride + i, b = a + 1, c = b + stride, d = a + stride;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

Mesh make_sphere(float radius, int segments) {
    return make_surface(segments, segments / 2, [=](float u, float v) {
        const float phi = kTwoPi * u, theta = kPi * (1 - v);
        const Vec3f n = around_z(std::sin(theta), std::cos(theta), phi);
        return Vertex{n * radius, n, around_z(1, 0, phi + kPi / 2), {}};
    });
}

Mesh make_plane(float half_x, float half_y) {
    return make_surface(1, 1, [=](float u, float v) {
        return Vertex{{(2 * u - 1) * half_x, (2 * v - 1) * half_y, 0}, {0, 0, 1}, {1, 0, 0}, {}};
    });
}

Mesh make_box(const Vec3f& half, float bevel, int steps) {
    const std::vector<Vec2f> profile = bevel_profile(steps);
    const int cells = static_cast<int>(profile.size()) - 1;
    Mesh box;
    for (int face = 0; face < 6; ++face) {
        const int w = face / 2;
        const float side = face % 2 ? -1.0f : 1.0f;
        const int x = (w + (side > 0 ? 1 : 2)) % 3, y = (w + (side > 0 ? 2 : 1)) % 3;
        append(box, make_surface(cells, cells, [&](float u, float v) {
                   const Vec2f a = profile[static_cast<size_t>(std::lround(u * static_cast<float>(cells)))];
                   const Vec2f b = profile[static_cast<size_t>(std::lround(v * static_cast<float>(cells)))];
                   Vec3f corner, n, axis(0.0f);
                   corner[w] = side * (half[w] - bevel), corner[x] = a.x * (half[x] - bevel),
                   corner[y] = b.x * (half[y] - bevel);
                   n[w] = side, n[x] = a.y, n[y] = b.y, axis[x] = 1;
                   n.normalize();
                   return Vertex{corner + n * bevel, n, Frame::along(n, axis).t, {}};
               }));
    }
    return box;
}

Mesh make_lathe(std::span<const Vec2f> profile, bool closed, int segments, int rows) {
    return make_surface(segments, rows, [=](float u, float v) {
        const auto [p, dp] = catmull_rom(profile, closed, v);
        const float phi = kTwoPi * u, slope = std::max(dp.length(), 1e-12f);
        const Vec3f n = around_z(dp.y / slope, -dp.x / slope, phi);
        return Vertex{around_z(std::max(p.x, 0.0f), p.y, phi), n, around_z(1, 0, phi + kPi / 2), {}};
    });
}

Mesh make_torus_knot(int p, int q, float radius, float tube, int segments, int sides) {
    const float winding = q == 0 ? 0.0f : 0.35f;
    const auto centre = [=](float s) {
        const float around = kTwoPi * s * static_cast<float>(p), across = kTwoPi * s * static_cast<float>(q);
        return around_z(radius * (1 + winding * std::cos(across)), radius * winding * std::sin(across), around);
    };
    return make_surface(sides, segments, [=](float u, float v) {
        const float step = 1e-3f;
        const Vec3f forward = (centre(v + step) - centre(v - step)).normalized();
        const Frame frame = Frame::along(forward, centre(v));
        const float phi = kTwoPi * u;
        const Vec3f n = frame.t * std::cos(phi) + frame.b * std::sin(phi);
        return Vertex{centre(v) + n * tube, n, forward.cross(n), {}};
    });
}

Mesh transformed(Mesh mesh, const Matrix44f& m) {
    const Matrix44f normals = m.inverse().transposed();
    for (Vertex& vertex : mesh.vertices) {
        Vec3f n, t;
        normals.multDirMatrix(vertex.n, n);
        m.multDirMatrix(vertex.t, t);
        vertex.p = vertex.p * m;
        vertex.n = n.normalized();
        vertex.t = Frame::along(vertex.n, t).t;
    }
    return mesh;
}

}  // namespace burnish
