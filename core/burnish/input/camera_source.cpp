#include <burnish/input/camera_source.h>

#include <burnish/base/json_text.h>
#include <burnish/input/camera_json.h>
#include <burnish/input/metadata.h>

#include <nlohmann/json.hpp>

namespace burnish {
namespace {

using nlohmann::json;

float display_aspect(const AovFrame& frame) {
    const double pixel = frame.metadata ? number_attribute(*frame.metadata, "PixelAspectRatio").value_or(1.0) : 1.0;
    return static_cast<float>(pixel * frame.display_window.width / frame.display_window.height);
}

Camera camera_from_text(const std::string& camera, const AovFrame& frame) {
    const bool is_text = camera.starts_with('{');
    const std::string where = is_text ? "camera" : camera;
    const json document = is_text ? parse_json(camera, where) : read_json(camera, "camera");
    const bool nested = document.is_object() && document.contains("camera");
    return camera_from_json(nested ? document["camera"] : document, nested ? where + ": camera" : where, display_aspect(frame));
}

}  // namespace

std::function<Camera(const AovFrame&)> camera_source(const std::string& camera) {
    if (camera.empty()) return {};
    return [camera](const AovFrame& frame) { return camera_from_text(camera, frame); };
}

}  // namespace burnish
