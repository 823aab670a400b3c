// Rays against a scene: closest hit and occlusion, by Embree.
#pragma once

#include <burnish/scene/scene.h>

#include <limits>
#include <memory>
#include <optional>
#include <span>

namespace burnish {

/// A point of a surface as a ray sees it; n, ng and t are unit vectors, n and ng on the side the ray came from.
struct Hit {
    float distance = 0;     // in lengths of the ray's direction
    int object = -1;        // index into Scene::objects
    uint32_t triangle = 0;  // index into its mesh
    bool front = true;      // met on the side that the triangle's corners go round counter-clockwise
    Vec3f p{0, 0, 0}, n{0, 0, 0}, ng{0, 0, 0}, t{0, 0, 0};  // world space; t is perpendicular to n
    Vec2f uv{0, 0};
};

inline constexpr float kInfinitelyFar = std::numeric_limits<float>::infinity();

class Tracer {
public:
    /// Builds the ray-tracing tree; the scene must outlive the tracer. Throws Error(bad_argument) for a triangle that names a
    /// vertex its mesh does not have.
    explicit Tracer(const Scene& scene);

    const Scene& scene() const { return *m_scene; }

    /// The first surface along origin + s direction, near < s < far; the direction need not be unit length. The ray goes through
    /// the objects of these indices. Thread-safe.
    std::optional<Hit> closest(const Vec3f& origin, const Vec3f& direction, float near = 0, float far = kInfinitelyFar,
                               std::span<const int> hidden = {}) const;

    /// Whether anything but the hidden objects lies along origin + s direction for 0 < s < distance. Thread-safe.
    bool occluded(const Vec3f& origin, const Vec3f& direction, float distance = kInfinitelyFar,
                  std::span<const int> hidden = {}) const;

private:
    struct Embree;
    const Scene* m_scene;
    std::shared_ptr<const Embree> m_embree;
};

/// Where a ray that leaves the surface at `hit` starts, so that it does not meet the surface it leaves.
Vec3f leaving_point(const Hit& hit);

}  // namespace burnish
