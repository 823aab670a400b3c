// burnish composite: frames in, frames with their overlay out.
#include "command.h"
#include "job_options.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/job/run.h>
#include <burnish/job/run_progressive.h>
#include <burnish/job/shot_file.h>

#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

struct Options : JobOptions {
    bool verbose = false, progressive = false;
};

void print_lines(const char* label, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) std::fprintf(stderr, "burnish: %s: %s\n", label, line.c_str());
}

void print(const Report& report, const Options& options) {
    if (options.verbose) print_lines("note", report.notes), print_lines("saved", report.saved);
    if (!options.quiet) print_lines("warning", report.warnings);
    for (const FrameReport& frame : report.frames) {
        if (options.verbose) print_lines("note", frame.notes), print_lines("saved", frame.saved);
        if (!options.quiet) print_lines("warning", frame.warnings);
        if (options.quiet || options.as_json) continue;
        std::printf("%s\n", summary(frame).c_str());
        for (const PlanReport& plan : frame.plan) std::printf("  %s\n", summary(plan).c_str());
    }
    if (options.as_json) std::printf("%s\n", report_to_json(report).dump(2).c_str());
}

void print_schema() {
    std::printf("%s\n", shot_schema().dump(2).c_str());
    throw CLI::Success();
}

/// One line a step; Ctrl-C is how looking ends: the last whole picture stays, and scripts are told.
int refine(const Job& job, const Options& options) {
    const auto tell = [&](const StepReport& step) {
        if (options.quiet || options.as_json) return;
        std::printf("step %d: %s, %.2f s, %.2f s since start%s\n", step.step, step.label.c_str(), step.seconds,
                    step.since_start, step.is_final ? ", final" : "");
        std::fflush(stdout);
    };
    ProgressDisplay display(options.quiet || options.progress == "auto" ? "none" : options.progress);
    const Report report = run_progressive(job, display.progress(), tell);
    print(report, options);
    return caught_signal() == 0 ? exit_code(report) : kSignalBase + caught_signal();
}

int composite(const Options& options) {
    const Job job = make_job(options);
    if (options.progressive) return refine(job, options);
    Report report;
    {
        ProgressDisplay display(options.quiet ? "none" : options.progress);
        report = run(job, display.progress());
    }
    print(report, options);
    return exit_code(report);
}

}  // namespace

Run add_composite(CLI::App& app) {
    auto* command = app.add_subcommand("composite", "Adds the specular overlay to rendered frames");
    auto options = std::make_shared<Options>();
    add_job_options(*command, *options);
    command->add_flag("-v,--verbose", options->verbose, "also print what was found and why");
    command->add_flag("--progressive", options->progressive,
                      "one frame: write a first picture at once, then better ones until the reference; Ctrl-C ends it");
    command->add_flag_callback("--schema", print_schema, "print the JSON schema of shot files and end");
    command->footer(
        "Lights near the objects (cubemap, mirror, area, traced) have names; rules choose them by these, or pixels by their "
        "place:\n"
        "--light 'lamp={\"type\": \"area\", \"corners\": [...]}' --assign gold=index:3@lamp,sky. The README tells their "
        "fields.\n\n"
        "Example: burnish composite beauty.exr --env studio.hdr --material chrome -o out.exr");
    return [options] { return composite(*options); };
}

}  // namespace burnish::cli
