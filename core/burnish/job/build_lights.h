// From what a job says of its lights to lights: pictures and geometry loaded, in the frame's colour space and axes.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/camera.h>
#include <burnish/input/renderer.h>
#include <burnish/job/job.h>
#include <burnish/job/rig.h>

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

/// The lights that `rules` can use, several at a time; not those of files with a frame number. `environment`: instead of the job's
/// file; null: that one, if there is one. Progress goes from 0 to 1 under "lights".
/// Throws Error(bad_argument | read_failed | missing_channel | color_space | cancelled).
Rig build_rig(const Job& job, const std::vector<AssignRule>& rules, const ColorFlow& color,
              std::shared_ptr<const Environment> environment, const LightFrame& frame, const Progress& progress);

/// What lights have to tell.
struct LightNotes {
    std::vector<std::string> notes, warnings;
};

/// Whether some light is another one for each frame.
bool has_frame_lights(const Rig& rig);
/// Loads these for the frame. Throws as build_rig.
LightNotes load_frame_lights(Rig& rig, const ColorFlow& color, const LightFrame& frame);

}  // namespace burnish
