// The frames of a job: which numbers, and which files belong to each.
#pragma once

#include <burnish/job/job.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

struct FrameTask {
    std::optional<int> frame;  // nothing for a job without a frame pattern
    std::string aovs, fine_aovs, camera, output, preview;
};

/// Whether there is an output of an earlier run that its inputs have not outdated.
bool is_up_to_date(const FrameTask& task);

/// Throws Error(bad_argument) when the job lacks an input or output, or names one file for several frames, and
/// Error(read_failed) when no file fits the pattern.
std::vector<FrameTask> frame_tasks(const Job& job);

}  // namespace burnish
