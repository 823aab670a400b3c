// Where bands go: the files of each frame, and its entry in the report.
#pragma once

#include <burnish/job/band.h>
#include <burnish/job/frame_tasks.h>
#include <burnish/job/job_hash.h>
#include <burnish/job/write_frame.h>

#include <optional>
#include <vector>

namespace burnish {

class FrameSink {
public:
    /// All arguments must outlive the sink. `progress`: of writing alone.
    FrameSink(const Job& job, const ColorFlow& color, const std::vector<FrameTask>& tasks, Progress progress, Report& report)
        : m_job(job), m_color(color), m_tasks(tasks), m_progress(std::move(progress)), m_report(report), m_output(job) {}

    /// Takes the next band, in order. `look`: what it was shaded with; null for one that was not. Throws the error of a band
    /// that ends the run, with its frame's number in front; the files of its frame are then gone.
    void take(Band& band, const Look* look);

private:
    void begin_frame(size_t task);
    void write(Band& band, const Look& look);
    void tell(const Band& band, const Look& look);
    void drop_frame(const Band& band, const Error& error);

    const Job& m_job;
    const ColorFlow& m_color;
    const std::vector<FrameTask>& m_tasks;
    Progress m_progress;
    Report& m_report;
    JoinedOutput m_output;
    std::string m_hash = job_hash(m_job);
    std::optional<size_t> m_task;         // the frame at hand
    std::optional<FrameWriter> m_writer;  // none once it failed
    Tally m_tally;
    int m_rows = 0;  // written
};

}  // namespace burnish
