#include <burnish/job/run_reported.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/job/run.h>
#include <burnish/job/shot_file.h>
#include <burnish/job/stages.h>
#include <burnish/output/exr_threads.h>
#include <burnish/output/exr_writer.h>

#include <nlohmann/json.hpp>

namespace burnish {
namespace {

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

Report run_reported(const Job& job, const std::function<void(Report&)>& work) {
    const ThreadLimit limit(job.threads);
    const ExrThreads exr_threads(job.threads);
    Report report;
    report.version = version();
    report.job = job_to_json(job).dump();
    try {
        timed(report.seconds, "total", [&] { work(report); });
    } catch (const Error& error) {
        if (error.code() != ErrorCode::cancelled) write_report_of_failure(job, report);
        throw;
    }
    write_report(job, report);
    return report;
}

}  // namespace burnish
