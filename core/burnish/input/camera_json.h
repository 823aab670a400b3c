// The camera as a JSON object: burnish's own form, which is also what its Blender add-on and the common exporters write.
//
//   by eye     {"position": [x,y,z], "look_at": [x,y,z], "up": [x,y,z], "fov_x_deg": 45}
//   by matrix  {"matrix_world": [[...],[...],[...],[0,0,0,1]], "fov_x_deg": 45, "shift": [0,0], "sensor_fit": "AUTO"}
//   centre     {"position": [x,y,z]}       enough for shading when the frame has a position layer
//
// matrix_world   camera to world, rows of a matrix for column vectors; the camera looks along its -Z, +Y up
// fov_x_deg      full horizontal angle of view, degrees (fov is the same); or fov_y_deg, or both (then the pixels need not be square)
// shift          lens shift, in widths of the sensor's fitted side (Blender's unit); right and up are positive
// sensor_fit     the fitted side: HORIZONTAL, VERTICAL or AUTO (the longer one, the default)
// Blender's type (PERSP only), lens_mm, sensor_width_mm, clip_start, clip_end and convention may be there, and say nothing new.
#pragma once

#include <burnish/input/camera.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace burnish {

/// `where` is the path to the object ("shot.json: camera") for messages; `aspect` the width over the height of the display
/// window, pixel aspect included. Throws Error(bad_argument) that names the field.
Camera camera_from_json(const nlohmann::json& json, const std::string& where, float aspect);

}  // namespace burnish
