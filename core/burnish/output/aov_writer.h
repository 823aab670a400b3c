// A frame to a file as a renderer would write it: all layers and cryptomattes in one multilayer EXR with the names of Cycles.
#pragma once

#include <burnish/input/frame.h>

#include <string>

namespace burnish {

/// Writes every layer that Cycles has a pass or a user AOV for, named "<view_layer>.<Pass>.<component>": colours half, data
/// 32-bit float, ZIP; and the frame's cryptomattes with their manifests (specification 1.2.0), prefix "<view_layer>.<name>".
/// The frame's camera, where it has rays, is in the header as worldToCamera; its angle of view is in the positions. Windows are the
/// frame's. Whole or not at all. Throws Error(write_failed).
void write_aovs(const std::string& file, const AovFrame& frame, const std::string& view_layer);

}  // namespace burnish
