// The output of a frame that is put together from several files: a view each, and the frame's own layers where they are kept. What has
// to wait does so in hidden files beside the output.
#pragma once

#include <burnish/job/frame_tasks.h>

#include <string>
#include <vector>

namespace burnish {

class JoinedOutput {
public:
    /// The job must outlive this.
    explicit JoinedOutput(const Job& job) : m_job(job) {}
    /// Removes the hidden files.
    ~JoinedOutput();
    JoinedOutput(const JoinedOutput&) = delete;
    JoinedOutput& operator=(const JoinedOutput&) = delete;

    /// Where burnish's own layers of this view are to be written: the output itself where nothing is put together. Throws
    /// Error(read_failed) when a view before failed.
    std::string begin(const FrameTask& task);
    /// They are written. With the last view the output is made. Throws Error(read_failed | write_failed).
    void finish(const FrameTask& task);

private:
    void join(const FrameTask& task);
    void clear();

    const Job& m_job;
    struct View {
        std::string file, name, frame;  // of burnish's layers; of the view; the frame it was made from
    };
    std::vector<View> m_views;
    size_t m_finished = 0;
};

}  // namespace burnish
