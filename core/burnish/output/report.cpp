#include <burnish/output/report.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace burnish {
namespace {

using nlohmann::json;

template <class T>
json object(const NamedValues<T>& values) {
    json result = json::object();
    for (const auto& [name, value] : values) result[name] = value;
    return result;
}

std::string status_name(FrameStatus status) {
    switch (status) {
        case FrameStatus::done: return "done";
        case FrameStatus::skipped: return "skipped";
        case FrameStatus::failed: return "failed";
    }
    return "";
}

/// JSON knows no infinity.
json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(); }

json plan_to_json(const PlanReport& plan) {
    json result = {{"material", plan.material},
                   {"lights", plan.lights},
                   {"plan", plan.words},
                   {"estimator", plan.estimator},
                   {"samples", plan.samples},
                   {"density", plan.safety > 0 ? "sparse" : "dense"},
                   {"lobes", plan.lobes},
                   {"dropped_lobes", plan.dropped_lobes},
                   {"target_db", plan.target_db},
                   {"expected_db", plan.expected_db},
                   {"expected_seconds", plan.expected_seconds},
                   {"found_db", number_or_null(plan.found_db)},
                   {"least_db", number_or_null(plan.least_db)},
                   {"largest_error", plan.largest_error},
                   {"checked_pixels", plan.checked_pixels},
                   {"corrected", plan.is_corrected},
                   {"missed", plan.is_missed}};
    if (plan.safety > 0) result["safety"] = plan.safety;
    if (plan.tolerance > 0) result["tolerance"] = plan.tolerance;
    return result;
}

json step_to_json(const StepReport& step) {
    return {{"step", step.step},       {"label", step.label},     {"is_final", step.is_final},
            {"lookups", step.lookups}, {"seconds", step.seconds}, {"since_start", step.since_start}};
}

}  // namespace

size_t Report::count(FrameStatus status) const {
    return static_cast<size_t>(
        std::count_if(frames.begin(), frames.end(), [&](const FrameReport& f) { return f.status == status; }));
}

json report_to_json(const FrameReport& frame) {
    json result = {{"status", status_name(frame.status)},
                   {"input", frame.input},
                   {"output", frame.output},
                   {"width", frame.width},
                   {"height", frame.height},
                   {"roles", frame.roles},
                   {"camera", frame.camera},
                   {"lookups", frame.lookups},
                   {"notes", frame.notes},
                   {"warnings", frame.warnings},
                   {"saved", frame.saved}};
    if (frame.frame) result["frame"] = *frame.frame;
    if (!frame.view.empty()) result["view"] = frame.view;
    if (!frame.error.empty()) result["error"] = frame.error;
    for (const StepReport& step : frame.steps) result["steps"].push_back(step_to_json(step));
    result["pixels"] = object(frame.pixels);
    result["materials"] = object(frame.materials);
    result["seconds"] = object(frame.seconds);
    for (const PlanReport& plan : frame.plan) result["plan"].push_back(plan_to_json(plan));
    return result;
}

json report_to_json(const Report& report) {
    json frames = json::array();
    for (const FrameReport& frame : report.frames) frames.push_back(report_to_json(frame));
    return {{"burnish", report.version},
            {"job", report.job.empty() ? json::object() : json::parse(report.job)},
            {"done", report.count(FrameStatus::done)},
            {"skipped", report.count(FrameStatus::skipped)},
            {"failed", report.count(FrameStatus::failed)},
            {"frames", frames},
            {"notes", report.notes},
            {"warnings", report.warnings},
            {"saved", report.saved},
            {"seconds", object(report.seconds)}};
}

std::string summary(const PlanReport& plan) {
    const bool is_beyond = !std::isfinite(plan.found_db);  // what the truth's own noise lets be told
    char found[200];
    std::snprintf(found, sizeof found,
                  ": %.1f dB%s of %.1f asked (at least %.1f, largest error %.1f %% of white, %zu pixels checked): ",
                  is_beyond ? plan.least_db : plan.found_db, is_beyond ? " or more" : "", plan.target_db, plan.least_db,
                  100 * plan.largest_error, plan.checked_pixels);
    std::string text = plan.material + found + plan.words;
    if (plan.dropped_lobes > 0)
        text += "; " + std::to_string(plan.dropped_lobes) + " of " + std::to_string(plan.lobes + plan.dropped_lobes) +
                " lobes left out";
    return text + (plan.is_corrected ? "; the first plan missed" : "");
}

std::string summary(const FrameReport& frame) {
    const std::string file = frame.output.empty() ? frame.input : frame.output;
    const std::string name = frame.view.empty() ? file : file + " (" + frame.view + ")";
    if (frame.status != FrameStatus::done) return name + "  " + status_name(frame.status) + ": " + frame.error;
    double total = 0, shading = 0;
    for (const auto& [stage, seconds] : frame.seconds) total += seconds, shading += stage == "shading" ? seconds : 0;
    char numbers[128];
    std::snprintf(numbers, sizeof numbers, "  %dx%d  %.2f s (shading %.2f)", frame.width, frame.height, total, shading);
    std::string materials;
    for (const auto& [material, pixels] : frame.materials)
        if (pixels > 0) materials += (materials.empty() ? "  " : ", ") + material + " on " + std::to_string(pixels);
    return name + numbers + (materials.empty() ? "  no pixel shaded" : materials + " pixels");
}

}  // namespace burnish
