#include <burnish/scene/mesh_frames.h>

#include <utility>

namespace burnish {

void set_face_normals(Mesh& mesh) {
    const std::vector<Vertex> shared = std::exchange(mesh.vertices, {});
    mesh.vertices.reserve(3 * mesh.triangles.size());
    for (auto& triangle : mesh.triangles) {
        const Vertex corners[] = {shared[triangle[0]], shared[triangle[1]], shared[triangle[2]]};
        const Vec3f n = (corners[1].p - corners[0].p).cross(corners[2].p - corners[0].p).normalized();
        for (int k = 0; k < 3; ++k) {
            triangle[k] = static_cast<uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(corners[k]);
            mesh.vertices.back().n = n;
        }
    }
}

void set_tangents(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices) vertex.t = Vec3f(0, 0, 0);
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vertex &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        const Vec2f along = b.uv - a.uv, across = c.uv - a.uv;
        const Vec3f rising = (b.p - a.p) * across.y - (c.p - a.p) * along.y;
        const Vec3f du = along.cross(across) < 0 ? -rising : rising;
        for (const uint32_t corner : {i, j, k}) mesh.vertices[corner].t += du;
    }
    for (Vertex& vertex : mesh.vertices) vertex.t = Frame::along(vertex.n, vertex.t.normalized()).t;
}

}  // namespace burnish
