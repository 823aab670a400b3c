#include <burnish/input/depth.h>
#include <burnish/input/frame_geometry.h>
#include <burnish/input/header_camera.h>
#include <burnish/input/metadata.h>
#include <burnish/input/recover_camera.h>
#include <burnish/input/role_checks.h>

#include <cstdio>

namespace burnish {
namespace {

std::optional<Camera> camera_of_header(AovFrame& frame, const RowStrips& rows, const Image* position, const Image* valid) {
    if (!frame.metadata) return std::nullopt;  // a frame of arrays has no header
    const float pixel_aspect = static_cast<float>(number_attribute(*frame.metadata, "PixelAspectRatio").value_or(1.0));
    std::string note;
    std::optional<Camera> camera =
        header_camera(camera_header(*frame.metadata), position, valid, rows, frame.display_window, pixel_aspect, note);
    if (!note.empty()) frame.notes.push_back(note);
    return camera;
}

}  // namespace

void find_camera(AovFrame& frame, const RowStrips& rows, const std::function<Camera(const AovFrame&)>& given) {
    if (given) {
        frame.camera = given(frame);
        frame.notes.push_back("camera as given");
        return;
    }
    const Image* position = frame.find(Role::position);
    const Image valid = position ? surface_mask(*position, frame.find(Role::normal)) : Image();
    frame.camera = camera_of_header(frame, rows, position, position ? &valid : nullptr);
    if (frame.camera || !position) {
        if (!frame.camera && frame.has(Role::depth))
            frame.warnings.push_back(
                "no camera: none in the header, and no position layer to recover it from; give the camera");
        return;
    }
    std::string note;
    frame.camera = recover_camera(*position, rows, frame.display_window, &valid, note);
    (frame.camera ? frame.notes : frame.warnings).push_back(note);
}

void warn_of_half_positions(const std::string& layer, AovFrame& frame) {
    const Image* position = frame.find(Role::position);
    if (!position) return;
    const HalfError error = half_error(*position, frame.camera ? frame.camera->centre : Vec3f(0));
    char steps[80], turn[80] = "";
    std::snprintf(steps, sizeof steps, " is stored as half floats, in steps of %.2g units here", error.step);
    if (frame.camera) std::snprintf(turn, sizeof turn, ", which turn the view by up to %.2g degrees", error.turn_deg);
    frame.warnings.push_back("position: " + layer + steps + turn + "; reflections may show bands. Render it as 32-bit float");
}

void judge_depth(AovFrame& frame, const RowStrips& rows) {
    if (!frame.has(Role::depth) || !frame.has(Role::position) || !frame.camera) return;
    switch (depth_kind(frame.layer(Role::depth), frame.layer(Role::position), *frame.camera, rows, frame.display_window)) {
        case DepthKind::planar: frame.notes.push_back("depth: planar, agrees with position"); return;
        case DepthKind::ray_distance: frame.notes.push_back("depth: length of the ray, agrees with position"); return;
        case DepthKind::neither: break;
    }
    frame.layers.erase(Role::depth);
    frame.notes.push_back("depth: neither planar nor ray length by the position layer (scaled or clamped?), not used");
}

bool complete_position(AovFrame& frame, const RowStrips& rows, bool ray_length) {
    if (frame.has(Role::position) || !frame.has(Role::depth) || !frame.camera || !frame.camera->has_rays) return false;
    frame.layers[Role::position] =
        position_from_depth(frame.layer(Role::depth), *frame.camera, rows, frame.display_window, ray_length);
    frame.notes.push_back(std::string("position: made from depth, taken as ") + (ray_length ? "ray length" : "planar depth"));
    return true;
}

}  // namespace burnish
