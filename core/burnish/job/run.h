// The one way through burnish: a job in, files and a report out.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/flow.h>
#include <burnish/job/job.h>
#include <burnish/output/report.h>

#include <memory>
#include <string>

namespace burnish {

/// Runs every frame of the job: reads, shades, composites and writes, whole files or none. Light and materials are prepared
/// once; reading, shading and writing overlap, and large frames go in bands (flow.h). Progress is told as (stage, share of the
/// whole run).
///
/// Frames that are missing, unreadable or lack a channel stop the run with an Error that starts with "frame=N", or are
/// reported and left out (Job::bad_frames). The report file is written in every case but cancellation.
/// Throws Error with any code; what was written before stays and is whole.
Report run(const Job& job, const Progress& progress, const FlowSettings& flow = {});

/// A job that is run in several goes, some of its frames each: light and materials are prepared by the first and kept for the others. As
/// a target is planned for with the first frame, pixels of a job with one depend on the goes.
class ShotRunner {
public:
    explicit ShotRunner(Job job);
    ~ShotRunner();

    /// As `run`, with the frames of this range. Not for several threads at once.
    Report run(const std::string& frames, const Progress& progress);
    /// As `run`.
    Report run(const FlowSettings& flow, const Progress& progress);

private:
    struct Prepared;
    Job m_job;
    std::unique_ptr<Prepared> m_prepared;
};

/// Version of the library, "major.minor.patch".
std::string_view version();

/// Exit code of a run that returned: 0, or 3 when some frames were skipped or failed.
int exit_code(const Report& report);

}  // namespace burnish
