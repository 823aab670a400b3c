#include <burnish/job/run.h>

#include <burnish/job/run_reported.h>

#include <algorithm>

namespace burnish {
namespace {

void run_frames(const Job& job, const FlowSettings& flow, const Progress& progress, Report& report) {
    const std::vector<FrameTask> tasks = frame_tasks(job);
    const ColorFlow color(job);
    const Wardrobe wardrobe = prepare_wardrobe(job);
    report.warnings = wardrobe.warnings;
    run_flow(job, flow, tasks, color, wardrobe, progress, report);
    progress.report("done", 1.0f);
}

}  // namespace

std::string_view version() { return BURNISH_VERSION; }

int exit_code(const Report& report) {
    constexpr int kPartial = 3;
    const auto told = [](const FrameReport& frame) { return !frame.error.empty(); };
    return std::any_of(report.frames.begin(), report.frames.end(), told) ? kPartial : 0;
}

Report run(const Job& job, const Progress& progress, const FlowSettings& flow) {
    return run_reported(job, [&](Report& report) { run_frames(job, flow, progress, report); });
}

}  // namespace burnish
