// What a run found, did and how long it took: for people one line a frame, for machines JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burnish {

enum class FrameStatus { done, skipped, failed };

/// Numbers by name, in the order they are told.
template <class T>
using NamedValues = std::vector<std::pair<std::string, T>>;

struct FrameReport {
    std::optional<int> frame;  // number, where the job has a frame pattern
    FrameStatus status = FrameStatus::done;
    std::string input, output;  // files; "" for arrays
    std::string error;          // why it was skipped or failed: "E_READ_FAILED message"
    int width = 0, height = 0;
    std::vector<std::string> roles;  // layers that were used
    std::string camera;              // where it came from
    NamedValues<size_t> pixels;      // by validity: valid, background, ...
    NamedValues<size_t> materials;   // shaded pixels of each rule
    double lookups = 0;              // in the light, all pixels
    NamedValues<double> seconds;     // wall time by stage
    std::vector<std::string> notes, warnings;
    std::vector<std::string> saved;  // what was not read or made, as nothing needed it
};

struct Report {
    std::string version;  // of burnish
    std::string job;      // the job as a shot file, JSON text
    std::vector<FrameReport> frames;
    std::vector<std::string> notes, warnings;  // about light and materials
    std::vector<std::string> saved;            // of the lights
    NamedValues<double> seconds;               // stages done once, and "total"

    size_t count(FrameStatus status) const;
};

nlohmann::json report_to_json(const Report& report);
nlohmann::json report_to_json(const FrameReport& frame);

/// "out.0012.exr  640x360  1.2 s (shading 0.9)  180 000 pixels in gold, varnish"
std::string summary(const FrameReport& frame);

}  // namespace burnish
