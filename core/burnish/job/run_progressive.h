// A job of one frame while someone looks: its files are written after every step, whole each time, so that a viewer can watch them.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/job.h>
#include <burnish/output/report.h>

#include <functional>

namespace burnish {

/// Reads the frame once, then writes output and preview step by step until the last one (refinement.h). `told` is called after each
/// step, its files written. When it is cancelled after the first picture the report tells so and how far it came; files are
/// those of the last whole step.
/// Throws Error with any code; bad_argument for a job of several frames, cancelled before there is any picture.
Report run_progressive(const Job& job, const Progress& progress, const std::function<void(const StepReport&)>& told);

}  // namespace burnish
