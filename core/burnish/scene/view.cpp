#include <burnish/scene/gbuffer.h>
#include <burnish/scene/view.h>

#include <algorithm>

namespace burnish {
namespace {

/// What is nearer to the plane lies on it.
float thickness(const Vec3f& point) {
    return 1e-4f * std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), 1.0f});
}

float height_over(const HalfSpace& space, const Vec3f& p) { return (p - space.point).dot(space.normal.normalized()); }

/// The half space with the camera on its side, or on the other one.
HalfSpace facing(HalfSpace space, const Camera& camera, bool to_camera) {
    if ((height_over(space, camera.centre) > 0) != to_camera) space.normal = -space.normal;
    return space;
}

}  // namespace

std::optional<Hit> View::closest(const Tracer& tracer, const Vec2f& raster) const {
    const Vec3f d = camera.ray(screen_point(raster, width, height));
    if (!within) return tracer.closest(camera.centre, d, 0, kInfinitelyFar, hidden);
    const float margin = thickness(within->point), short_of = margin - height_over(*within, camera.centre);
    const float climb = d.dot(within->normal.normalized());
    if (short_of > 0 && climb <= 0) return std::nullopt;
    const float start = short_of > 0 ? short_of / climb : 0.0f;
    const auto hit = tracer.closest(camera.centre, d, start, kInfinitelyFar, hidden);
    if (!hit || height_over(*within, hit->p) < 0.5f * margin) return std::nullopt;
    return hit;
}

Camera mirrored(const Camera& camera, const HalfSpace& mirror) {
    const Vec3f n = mirror.normal.normalized();
    const auto reflected = [&](const Vec3f& v) { return v - n * (2 * n.dot(v)); };
    Camera image = camera;
    image.centre = camera.centre - n * (2 * height_over(mirror, camera.centre));
    image.axis = reflected(camera.axis), image.right = -reflected(camera.right), image.up = reflected(camera.up);
    return image;
}

View mirror_view(const View& view, const HalfSpace& mirror) {
    View seen = view;
    seen.camera = mirrored(view.camera, mirror);
    seen.within = facing(mirror, view.camera, true);
    return seen;
}

View behind_view(const View& view, const HalfSpace& pane) {
    View seen = view;
    seen.within = facing(pane, view.camera, false);
    return seen;
}

}  // namespace burnish
