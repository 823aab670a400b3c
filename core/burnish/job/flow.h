// The frames of a job on their way from file to file: while one band is shaded the next is read and the one before is written.
//
//     read -> shade -> write      each in order and one band at a time; bounded in flight, and so in memory
//
// Shading runs on all threads that reading and writing leave idle.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/frame_tasks.h>
#include <burnish/job/look.h>
#include <burnish/output/report.h>

#include <optional>
#include <vector>

namespace burnish {

struct FlowSettings {
    size_t band_pixels = size_t{1} << 21;  // larger frames go in bands of rows; 1920 x 1080 is just below, about 0.2 GB
    int bands_in_flight = 3;
};

/// Runs the tasks and adds to `report` one entry a frame, in order, and what light and tables tell. Frames that fail stop the
/// run once all before them are written, or are passed over, as the job says. Pixels and report do not depend on `settings`. `look`:
/// made with the first frame unless it is there; another run of the same job may use it again.
/// Throws what `run` throws.
void run_flow(const Job& job, const FlowSettings& settings, const std::vector<FrameTask>& tasks, const ColorFlow& color,
              const Wardrobe& wardrobe, std::optional<Look>& look, const Progress& progress, Report& report);

}  // namespace burnish
