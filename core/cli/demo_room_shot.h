// The shot that `burnish demo --scene room` makes: a room, baked into lights near its objects.
#pragma once

#include <burnish/job/bake.h>

#include <filesystem>

namespace burnish::cli {

/// The bake of the demo's room: a cube map an object, mirrors in floor and table top, what is behind the panes, and the frame.
BakeJob demo_room_job(const std::filesystem::path& folder, int width, int height);

/// Bakes the room's light maps and pictures into the folder, and writes a shot.json that composites them.
BakeReport write_demo_room_shot(const std::filesystem::path& folder, int width, int height, const Progress& progress);

}  // namespace burnish::cli
