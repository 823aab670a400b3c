// File to frame: the only place that reads AOV pixels (OpenImageIO). Reads only the channels that are needed.
#pragma once

#include <burnish/input/frame.h>

#include <map>
#include <set>
#include <string>

namespace burnish {

struct ReadOptions {
    std::set<Role> roles;                          // roles wanted; empty = all that are found
    std::map<Role, std::string> channels;          // explicit layer per role ("ViewLayer.Normal"), wins over names
    bool cryptomattes = false;                     // decode cryptomatte layers too
    std::string view;                              // multi-view files: "left", "right"; empty = first
};

/// Reads a frame: resolves roles by name and checks them by numbers, decodes encoded normals, makes position from depth
/// where needed, finds or recovers the camera. Throws Error(read_failed) for absent, corrupt, deep or unsupported files.
AovFrame read_frame(const std::string& file, const ReadOptions& options);

}  // namespace burnish
