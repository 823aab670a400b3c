// The scene of `burnish demo --scene room`: a room with patterned walls, two lamps, a polished floor, a lacquered table, metal, and
// two panes of glass with things behind.
#pragma once

#include <burnish/scene/demo_scene.h>

namespace burnish {

/// Z up, metres. Objects that shine name presets as their materials; there are twelve besides the floor. Panes are called pane_*,
/// the floor's tiles floor_*.
Scene make_demo_room();

Viewpoint demo_room_viewpoint();

}  // namespace burnish
