// From what a job says of its lights to lights: pictures and geometry loaded, in the frame's colour space and axes.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/camera.h>
#include <burnish/input/renderer.h>
#include <burnish/job/assign_lights.h>
#include <burnish/job/job.h>
#include <burnish/job/rig.h>
#include <burnish/output/report.h>

namespace burnish {

class ColorFlow;

/// What lights take from the frame that they light.
struct LightFrame {
    Renderer renderer = Renderer::unknown;  // an up axis left to burnish is the one of the frame's renderer
    std::optional<Camera> camera;
    std::optional<int> number;  // of a sequence
};

/// An up axis left to burnish is the one of the frame's renderer: Blender's world has Z up; the others stay with the default until
/// their user says otherwise.
UpAxis settled_up(UpAxis up, Renderer renderer);

/// The lights that `rules` can use; those near the objects are loaded when needed, but their files must be there.
/// `environment`: instead of the job's file; null: that one, if there is one.
/// Throws Error(bad_argument | read_failed | missing_channel | color_space).
Rig build_rig(const Job& job, const std::vector<AssignRule>& rules, const ColorFlow& color,
              std::shared_ptr<const Environment> environment, const LightFrame& frame);

/// Loads the lights of these chains that nobody needed before, several at a time, and filters them; their time goes to `seconds`
/// under "light". Throws Error(bad_argument | read_failed | missing_channel | color_space | cancelled).
void load_needed(const Rig& rig, const std::vector<LitRule>& looks, NamedValues<double>& seconds, const Progress& progress);

/// Whether some light is another one for each frame.
bool has_frame_lights(const Rig& rig);
/// Loads these for the frame. Throws as build_rig.
LightNotes load_frame_lights(Rig& rig, const ColorFlow& color, const LightFrame& frame);

}  // namespace burnish
