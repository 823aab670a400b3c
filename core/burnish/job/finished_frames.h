// Which frames need not be made again: their output is of the same job, whole, and newer than everything it was made from.
#pragma once

#include <burnish/job/frame_tasks.h>
#include <burnish/job/look.h>

#include <string>
#include <vector>

namespace burnish {

class FinishedFrames {
public:
    /// `kind`: of output, see job_hash.h.
    FinishedFrames(const Job& job, const Wardrobe& wardrobe, const std::string& kind = "composite");

    /// Reads the output's header and where its chunks lie, no pixels.
    bool has(const FrameTask& task) const;

private:
    bool is_newer_than_inputs(const std::string& output, const FrameTask& task) const;

    bool m_is_asked;
    std::string m_hash;
    std::vector<std::string> m_inputs;  // that all frames share, or patterns of one file a frame
};

}  // namespace burnish
