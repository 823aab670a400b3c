// File to frame: the only place that reads AOV pixels (OpenImageIO). Reads only the channels that are needed.
#pragma once

#include <burnish/input/frame.h>

#include <functional>
#include <map>
#include <set>
#include <string>

namespace burnish {

struct ReadOptions {
    std::set<Role> roles;                           // roles wanted; empty = all that are found
    std::map<Role, std::string> channels;           // explicit layer per role ("ViewLayer.Normal"), wins over names
    std::map<Role, std::set<Role>> substitutes;     // roles wanted only where this one is not found: uv for tangent
    bool cryptomattes = false;                      // decode cryptomatte layers too
    int shaded_block = 1;                           // bands: see FrameReader::read_rows
    std::string view;                               // multi-view files: "left", "right"; empty = first
    std::function<Camera(const AovFrame&)> camera;  // explicit camera, wins over header and recovery; asked when the frame's
                                                    // windows are known; empty = none
};

/// Reads a frame: resolves roles by name and checks them by numbers, decodes encoded normals, makes position from depth
/// where needed, finds the camera (explicit, else the header's, else recovered from position). A layer that fails its check
/// is passed over for the next of that role; `notes` has one line for each decision, `warnings` what may be wrong.
/// Roles nothing fills are left out; AovFrame::layer throws when one is asked for.
/// Throws Error(read_failed) for absent, corrupt, deep or unsupported files, Error(missing_channel) for a layer named in
/// `channels` that is not there, Error(bad_argument) for a view that is not.
AovFrame read_frame(const std::string& file, const ReadOptions& options);

}  // namespace burnish
