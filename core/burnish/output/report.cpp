#include <burnish/output/report.h>

#include <nlohmann/json.hpp>

#include <algorithm>
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
    if (!frame.error.empty()) result["error"] = frame.error;
    result["pixels"] = object(frame.pixels);
    result["materials"] = object(frame.materials);
    result["seconds"] = object(frame.seconds);
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

std::string summary(const FrameReport& frame) {
    const std::string name = frame.output.empty() ? frame.input : frame.output;
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
