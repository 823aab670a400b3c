// A finished frame to its files: EXR layers and preview.
#pragma once

#include <burnish/job/color_flow.h>
#include <burnish/job/frame_tasks.h>
#include <burnish/job/run_frame.h>

namespace burnish {

/// Layers: R G B A, burnish_spec (the overlay as added), burnish_diffuse where the frame had no beauty; with diagnostics also
/// burnish_validity, burnish_samples and burnish_error. Colours go to the job's output space; `result` is used up.
/// Throws Error(write_failed | color_space).
void write_frame(const Job& job, const ColorFlow& color, const FrameTask& task, const AovFrame& frame, FrameResult& result);

}  // namespace burnish
