#include <burnish/light/mirror/mirror_buffer.h>

#include <burnish/base/error.h>
#include <burnish/input/camera_source.h>
#include <burnish/input/exr_reader.h>
#include <burnish/input/median.h>
#include <burnish/input/sightings.h>
#include <burnish/light/mirror/plane.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr size_t kSightings = 2000;
constexpr double kGoodMiss = 0.5;  // pixels, at the median

AovFrame read(const MirrorSettings& settings, const std::function<Camera(const AovFrame&)>& camera) {
    ReadOptions options;
    options.roles = {Role::beauty, Role::alpha, Role::position, Role::depth, Role::normal, Role::geometric_normal};
    options.camera = camera;
    return read_frame(settings.file, options);
}

/// Median distance of the frame's places from the pixels that show them, by this camera; pixels.
double median_miss(const AovFrame& frame, const Camera& camera) {
    const Window& display = frame.display_window;
    std::vector<double> misses;
    for (const Sighting& s : sample_sightings(frame.layer(Role::position), nullptr, frame.data_window, display, kSightings)) {
        const std::optional<Vec2f> seen = camera.project(Vec3f(s.point));
        const double x = seen ? seen->x - s.screen.x : 2, y = seen ? seen->y - s.screen.y : 2;
        misses.push_back(0.5 * std::hypot(x * display.width, y * display.height));
    }
    return median(misses);
}

/// The camera, or the way it is turned, that sees the frame's places where they are.
Camera turned_to_fit(const AovFrame& frame, const Camera& camera) {
    Camera best = camera;
    double least = median_miss(frame, camera);
    for (const Vec2f& sign : {Vec2f(-1, 1), Vec2f(1, -1), Vec2f(-1, -1)}) {
        Camera turned = camera;
        turned.right *= sign.x, turned.up *= sign.y;
        const double miss = least > kGoodMiss ? median_miss(frame, turned) : least;
        if (miss < least) best = turned, least = miss;
    }
    return best;
}

/// The frame, with a camera that has rays.
AovFrame frame_with_camera(const MirrorSettings& settings, const std::optional<Camera>& frame_camera) {
    AovFrame frame = read(settings, camera_source(settings.camera));
    const bool is_known = frame.camera && frame.camera->has_rays;
    if (is_known || !frame_camera || !settings.camera.empty()) return frame;
    const Camera expected = settings.behind ? *frame_camera : mirrored(*frame_camera, settings.plane);
    if (frame.has(Role::position)) {
        frame.camera = turned_to_fit(frame, expected);
        frame.warnings.clear();
    } else {
        frame = read(settings, [&](const AovFrame&) { return expected; });
    }
    frame.notes.push_back(settings.behind ? "camera: the frame's" : "camera: the frame's, mirrored");
    return frame;
}

Image light_of(const AovFrame& frame, const Image& position) {
    const Image &beauty = frame.layer(Role::beauty), *alpha = frame.find(Role::alpha);
    Image light(beauty.width, beauty.height, 4);
    for (size_t i = 0; i < light.pixel_count(); ++i) {
        float brightest = 0;
        for (int k = 0; k < 3; ++k) {
            light.at(i)[k] = std::max(beauty.at(i)[k], 0.0f);
            brightest = std::max(brightest, light.at(i)[k]);
        }
        const float known = is_hit(position.at(i)) || brightest > 0 ? 1.0f : 0.0f;
        light.at(i)[3] = alpha ? std::clamp(*alpha->at(i), 0.0f, 1.0f) : known;
    }
    return light;
}

}  // namespace

MirrorBuffer MirrorBuffer::from_frame(AovFrame frame) {
    if (!frame.camera || !frame.camera->has_rays)
        throw Error(ErrorCode::bad_argument, frame.label() +
                                                 ": a mirrored render needs its camera with its field of view; give "
                                                 "`camera`, or a layer of world positions to recover it from");
    MirrorBuffer buffer;
    const Role normal = frame.has(Role::geometric_normal) ? Role::geometric_normal : Role::normal;
    buffer.light = light_of(frame, frame.layer(Role::position));
    buffer.position = std::move(frame.layers[Role::position]), buffer.normal = frame.layer(normal);
    buffer.camera = *frame.camera, buffer.data = frame.data_window, buffer.display = frame.display_window;
    buffer.notes = std::move(frame.notes), buffer.warnings = std::move(frame.warnings);
    return buffer;
}

MirrorBuffer MirrorBuffer::load(const MirrorSettings& settings, const std::optional<Camera>& frame_camera,
                                const std::function<void(Image&)>& convert) {
    AovFrame frame = frame_with_camera(settings, frame_camera);
    if (convert && frame.has(Role::beauty)) convert(frame.layers[Role::beauty]);
    return from_frame(std::move(frame));
}

}  // namespace burnish
