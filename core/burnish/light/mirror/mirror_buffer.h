// What a mirrored render holds, read from any renderer's file: light, places and normals, and the camera that saw them.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/light/light_settings.h>

#include <functional>
#include <optional>

namespace burnish {

struct MirrorBuffer {
    Image light;             // RGBA, linear, >= 0, premultiplied; A: how far the picture knows what is seen there, [0, 1]
    Image position, normal;  // world space, of the places seen; the normal a unit vector
    Camera camera;
    Window data, display;
    std::vector<std::string> notes, warnings;

    /// Of a frame with beauty, position (or depth), normal and a camera. Without alpha, where nothing was hit the picture knows
    /// what it shows unless it is black. Throws Error(missing_channel | bad_argument).
    static MirrorBuffer from_frame(AovFrame frame);

    /// Reads settings.file as read_frame does. The camera is the one in settings.camera; else the file's; else `frame_camera`,
    /// for a mirror its mirror image, turned left for right or upside down where the places say so.
    /// `convert` takes RGB into the colour space of the work; empty = it is there. Throws what read_frame throws.
    static MirrorBuffer load(const MirrorSettings& settings, const std::optional<Camera>& frame_camera,
                             const std::function<void(Image&)>& convert = {});
};

}  // namespace burnish
