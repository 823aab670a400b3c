#include <burnish/job/run.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/job/shot_file.h>
#include <burnish/job/stages.h>
#include <burnish/output/exr_threads.h>
#include <burnish/output/exr_writer.h>

#include <nlohmann/json.hpp>

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

void write_report(const Job& job, const Report& report) {
    if (!job.output.report.empty()) write_text(job.output.report, report_to_json(report).dump(2) + "\n");
}

/// What made the run fail is the error to tell, not a report that could not be written either.
void write_report_of_failure(const Job& job, const Report& report) {
    try {
        write_report(job, report);
    } catch (const Error&) {
    }
}

}  // namespace

std::string_view version() { return BURNISH_VERSION; }

int exit_code(const Report& report) {
    constexpr int kPartial = 3;
    const auto told = [](const FrameReport& frame) { return !frame.error.empty(); };
    return std::any_of(report.frames.begin(), report.frames.end(), told) ? kPartial : 0;
}

Report run(const Job& job, const Progress& progress, const FlowSettings& flow) {
    const ThreadLimit limit(job.threads);
    const ExrThreads exr_threads(job.threads);
    Report report;
    report.version = version();
    report.job = job_to_json(job).dump();
    try {
        timed(report.seconds, "total", [&] { run_frames(job, flow, progress, report); });
    } catch (const Error& error) {
        if (error.code() != ErrorCode::cancelled) write_report_of_failure(job, report);
        throw;
    }
    write_report(job, report);
    return report;
}

}  // namespace burnish
