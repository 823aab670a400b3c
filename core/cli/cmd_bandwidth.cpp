// burnish bandwidth: how fast the overlay is predicted to vary over each frame, for seeing why sparse shading does what it does.
#include "command.h"
#include "job_options.h"
#include "progress_display.h"

#include <burnish/job/run_bandwidth.h>
#include <burnish/output/level_colors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

constexpr const char* kLayers =
    "Takes what composite takes, so the same line with another word shows what that job does; settings of compositing play no "
    "part.\n"
    "\n"
    "Writes an EXR of one part a pyramid level: level_0 holds every pixel, level_1 every second one, and so on. Its layers:\n"
    "  bandwidth  of the overlay, cycles per pixel; two samples a cycle will do\n"
    "  level      where to shade: every 2^level-th pixel; coarser levels hold the smallest of their pixels\n"
    "  samples    per pixel for equal noise, 1 on average; this one and the others: the largest of their pixels\n"
    "  curvature  of the surface, 1 per scene unit\n"
    "  nu_a       of the overlay, cycles per radian of the reflected direction\n"
    "\n"
    "--preview writes a PNG of level, with this scale along its lower edge:\n ";

std::string footer() {
    std::string text = kLayers;
    for (size_t level = 0; level < kLevelColors.size(); ++level) {
        const bool is_last = level + 1 == kLevelColors.size();
        text += " " + std::to_string(level) + (is_last ? "+ " : " ") + kLevelColors[level].name + (is_last ? "; " : ",");
    }
    return text +
           "not shaded black\n\nExample: burnish bandwidth beauty.exr --env studio.hdr --material chrome -o bandwidth.exr";
}

int bandwidth(const JobOptions& options) {
    const Job job = make_job(options);
    std::vector<BandwidthReport> reports;
    {
        ProgressDisplay display(options.quiet ? "none" : options.progress);
        reports = run_bandwidth(job, display.progress());
    }
    for (const BandwidthReport& report : reports)
        if (!options.quiet && !options.as_json) std::printf("%s\n", summary(report).c_str());
    if (options.as_json) std::printf("%s\n", report_to_json(reports).dump(2).c_str());
    constexpr int kPartial = 3;
    return std::ranges::any_of(reports, [](const BandwidthReport& r) { return !r.error.empty(); }) ? kPartial : 0;
}

}  // namespace

Run add_bandwidth(CLI::App& app) {
    auto* command = app.add_subcommand("bandwidth", "Shows where and how fast the overlay is predicted to vary");
    auto options = std::make_shared<JobOptions>();
    add_job_options(*command, *options);
    command->footer(footer());
    return [options] { return bandwidth(*options); };
}

}  // namespace burnish::cli
