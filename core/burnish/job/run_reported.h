// What every run has around it: the job's threads, its clock, and its report, also of a run that fails.
#pragma once

#include <burnish/job/job.h>
#include <burnish/output/report.h>

#include <functional>

namespace burnish {

/// Runs `work`, which fills the report, with "total" its wall time, and writes the job's report file in every case but cancellation.
/// Throws what `work` throws, and Error(write_failed).
Report run_reported(const Job& job, const std::function<void(Report&)>& work);

}  // namespace burnish
