// The frames of a job, and their views: which numbers, and which files belong to each.
#pragma once

#include <burnish/job/job.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

/// One view of one frame.
struct FrameTask {
    std::optional<int> frame;  // nothing for a job without a frame pattern
    std::string aovs, fine_aovs, camera, output, preview;
    std::string view = {};          // "" = the first, or the only one
    std::string view_in_file = {};  // to be read, as ReadOptions takes it
    size_t views = 1;               // of the frame, this one counted, that share the output; their tasks follow each other
    bool is_last_view = true;
};

/// With Job::view "all" a task for each view: those of the first file that can be read, or left and right where the frame's name
/// holds %V. Throws Error(bad_argument) when the job lacks an input or output, or names one file for several frames, and
/// Error(read_failed) when no file fits the pattern.
std::vector<FrameTask> frame_tasks(const Job& job);

}  // namespace burnish
