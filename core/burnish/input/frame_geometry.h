// The geometry of a frame once its layers are read: the camera, and how position and depth agree with it. The layers may hold
// strips of the frame only (`rows`).
#pragma once

#include <burnish/input/frame.h>
#include <burnish/input/row_strips.h>

#include <functional>

namespace burnish {

/// Gives the frame its camera: the explicit one (`given` may be empty), else the header's if it agrees with the position
/// layer, else the one recovered from position. Says in notes which and why; a frame without camera gets a warning when it
/// has positions or depth.
void find_camera(AovFrame& frame, const RowStrips& rows, const std::function<Camera(const AovFrame&)>& given);

/// With position, which is stored as half floats: warns of what that costs.
void warn_of_half_positions(const std::string& layer, AovFrame& frame);

/// With position and a camera: notes whether depth is planar or ray length, and takes depth out when it is neither.
void judge_depth(AovFrame& frame, const RowStrips& rows);

/// Without position, but with depth and a camera with rays: makes position and returns true. `ray_length`: what the depth
/// measures.
bool complete_position(AovFrame& frame, const RowStrips& rows, bool ray_length);

}  // namespace burnish
