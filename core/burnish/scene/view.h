// A camera's look at a scene, as mirrors and panes need it: some objects are not there, and what lies before a plane is not seen.
#pragma once

#include <burnish/input/camera.h>
#include <burnish/scene/trace.h>

#include <optional>
#include <vector>

namespace burnish {

/// The side of a plane that its normal points to. The normal need not be a unit vector, but not zero either.
struct HalfSpace {
    Vec3f point{0, 0, 0}, normal{0, 0, 1};
};

struct View {
    Camera camera;  // with rays
    int width = 0, height = 0;
    std::vector<int> hidden = {};                    // indices into Scene::objects
    std::optional<HalfSpace> within = std::nullopt;  // nothing outside is seen, nor what lies on its plane

    /// What is seen at a raster position (pixels, see gbuffer.h); the hit's distance is its planar depth. Thread-safe.
    std::optional<Hit> closest(const Tracer& tracer, const Vec2f& raster) const;
};

/// The camera that sees in the plane's mirror image what `camera` sees in the mirror. It is no mirrored camera, but one that can
/// be built: pixel (x, y) of the one sees what pixel (width - 1 - x, y) of the other is reflected to.
Camera mirrored(const Camera& camera, const HalfSpace& mirror);

/// What the mirror shows `view`: seen by the mirrored camera, only what is on the side of the plane that the camera is on.
View mirror_view(const View& view, const HalfSpace& mirror);
/// What `view` sees through a pane: only what is on the other side of the plane.
View behind_view(const View& view, const HalfSpace& pane);

}  // namespace burnish
