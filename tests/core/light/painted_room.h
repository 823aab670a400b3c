// A room known in closed form: a box whose walls are painted by a formula, empty or with a smaller box standing in it, and cube
// maps of it taken from any point. World axes are the light's.
#pragma once

#include "light_pictures.h"

#include <burnish/light/environment_picture.h>
#include <burnish/light/light_settings.h>
#include <burnish/scene/scene.h>

#include <limits>
#include <memory>
#include <optional>

namespace burnish_test {

struct PaintedRoom {
    Vec3f low{-3, -1, -4}, high{3, 2, 4};  // Y up
    std::optional<OrientedBox> block;

    struct Place {
        Vec3f x;
        bool on_block;
    };

    /// Where the ray from p (inside) along d ends.
    Place end(const Vec3f& p, const Vec3f& d) const {
        float t = std::numeric_limits<float>::infinity();
        for (int k = 0; k < 3; ++k)
            if (d[k] != 0) t = std::min(t, ((d[k] > 0 ? high[k] : low[k]) - p[k]) / d[k]);
        const float near = block_distance(p, d);
        return near < t ? Place{p + d * near, true} : Place{p + d * t, false};
    }

    /// Smooth, at least 0.2, the same for neighbours across a corner.
    static Color3f paint(const Vec3f& x) {
        const auto wave = [](float a) { return 1.2f + std::sin(a); };
        return {wave(2 * x.x + 1), wave(2.5f * x.y + x.z), wave(2 * x.z - x.x)};
    }
    Color3f seen(const Vec3f& p, const Vec3f& d) const {
        const Place place = end(p, d);
        return place.on_block ? Color3f(paint(place.x * 2.0f)) : paint(place.x);
    }

    bool in_block(const Vec3f& p) const {
        if (!block) return false;
        const Vec3f x = p - block->centre;
        return std::fabs(x.dot(block->x)) < block->half.x && std::fabs(x.dot(block->y)) < block->half.y &&
               std::fabs(x.dot(block->z)) < block->half.z;
    }

    OrientedBox box() const { return {(low + high) * 0.5f, (high - low) * 0.5f}; }
    std::vector<Plane> planes() const {
        return {{low, {1, 0, 0}}, {high, {-2, 0, 0}}, {low, {0, 1, 0}}, {high, {0, 1, 0}}, {low, {0, 0, 1}}, {high, {0, 0, 3}}};
    }

    EnvironmentPicture picture(const Vec3f& centre, int size) const {
        return as_picture(painted_faces(size, [&](const Vec3f& d) { return seen(centre, d); }));
    }
    /// Distances in one channel, along rays or along the faces' axes.
    EnvironmentPicture distances(const Vec3f& centre, int size, DistanceKind kind = DistanceKind::ray) const {
        const auto lengths = painted_faces(size, [&](const Vec3f& d) {
            const float along = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
            return Color3f((end(centre, d).x - centre).length() * (kind == DistanceKind::planar ? along : 1.0f));
        });
        std::array<Image, 6> faces;
        for (int face = 0; face < 6; ++face) {
            faces[face] = Image(size, size, 1);
            for (size_t i = 0; i < faces[face].pixel_count(); ++i) *faces[face].at(i) = lengths[face].at(i)[0];
        }
        return as_picture(std::move(faces));
    }

    /// Walls, and the block if there is one.
    std::shared_ptr<const Scene> scene() const {
        auto scene = std::make_shared<Scene>();
        scene->objects.push_back({"walls", "", mesh_of(box())});
        if (block) scene->objects.push_back({"block", "", mesh_of(*block)});
        return scene;
    }

    Vec3f inside(Directions& random, float margin) const {
        Vec3f p;
        for (int k = 0; k < 3; ++k) p[k] = low[k] + margin + (high[k] - low[k] - 2 * margin) * random.uniform();
        return p;
    }

private:
    static EnvironmentPicture as_picture(std::array<Image, 6> faces) {
        EnvironmentPicture picture;
        picture.faces = std::move(faces);
        return picture;
    }

    float block_distance(const Vec3f& p, const Vec3f& d) const {
        if (!block) return std::numeric_limits<float>::infinity();
        const Vec3f axes[3] = {block->x, block->y, block->z};
        float enter = 0, leave = std::numeric_limits<float>::infinity();
        for (int k = 0; k < 3; ++k) {
            const float at = axes[k].dot(p - block->centre), speed = axes[k].dot(d);
            const float a = (-block->half[k] - at) / speed, b = (block->half[k] - at) / speed;
            enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
        }
        return enter < leave && enter > 0 ? enter : std::numeric_limits<float>::infinity();
    }

    static Mesh mesh_of(const OrientedBox& box) {
        Mesh mesh;
        for (int i = 0; i < 8; ++i) {
            const auto side = [&](int bit) { return i >> bit & 1 ? 1.0f : -1.0f; };
            const Vec3f p =
                box.centre + box.x * (side(0) * box.half.x) + box.y * (side(1) * box.half.y) + box.z * (side(2) * box.half.z);
            mesh.vertices.push_back({p, {0, 0, 1}, {1, 0, 0}, {0, 0}});
        }
        for (const auto& [a, b, c, d] :
             {std::array<uint32_t, 4>{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
            mesh.triangles.push_back({a, b, c}), mesh.triangles.push_back({a, c, d});
        return mesh;
    }
};

/// A block to stand in the room: 1 across, 1.2 high, turned.
inline OrientedBox standing_block() {
    const float c = std::cos(0.5f), s = std::sin(0.5f);
    return {{1.5f, -0.4f, -1.6f}, {0.5f, 0.6f, 0.5f}, {c, 0, s}, {0, 1, 0}, {-s, 0, c}};
}

}  // namespace burnish_test
