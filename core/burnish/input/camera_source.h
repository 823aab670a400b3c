// A camera as users give it: the JSON of camera_json.h itself, or the name of a file that holds it.
#pragma once

#include <burnish/input/frame.h>

#include <functional>
#include <string>

namespace burnish {

/// For ReadOptions::camera: empty for "". A file may hold the camera itself, or an exporter's larger document with a "camera" in
/// it. What is returned throws Error(read_failed | bad_argument).
std::function<Camera(const AovFrame&)> camera_source(const std::string& camera);

}  // namespace burnish
