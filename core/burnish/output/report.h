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

/// How a material was shaded to meet a target, and how near it came at the pixels that were checked. dB of display PSNR.
struct PlanReport {
    std::string material;
    std::vector<std::string> lights;  // the one in front first
    std::string words;                // "fitted, 6 lookups a lobe, sparse at safety 1"
    std::string estimator;            // and its settings, as a job takes them
    int samples = 0;
    float safety = 0, tolerance = 0;  // 0: dense; 0: not `reference`
    size_t lobes = 0, dropped_lobes = 0;
    double target_db = 0;  // asked for, or what the time allows
    double expected_db = 0, expected_seconds = 0;
    double found_db = 0;       // at the checked pixels; infinite where no difference was found
    double least_db = 0;       // it is at least so much, in nine of ten draws of pixels
    double largest_error = 0;  // of white
    size_t checked_pixels = 0;
    bool is_corrected = false;  // the first plan missed the target
    bool is_missed = false;     // the last one, too
};

/// One picture of a frame that was refined step by step.
struct StepReport {
    int step = 0;
    std::string label;
    bool is_final = false;
    double lookups = 0;                   // in the light, of this picture
    double seconds = 0, since_start = 0;  // wall time of the step, and until its picture was there
};

struct FrameReport {
    std::optional<int> frame;  // number, where the job has a frame pattern
    std::string view;          // "" = the first, or the only one
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
    std::vector<PlanReport> plan;    // of each material under its lights, where the job has a target
    std::vector<StepReport> steps;   // progressive runs only; the other numbers are of the last step
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

/// "gold: 45.6 dB of 45 asked (at least 45.1, 300 pixels checked): fitted, 6 lookups a lobe, sparse at safety 1"
std::string summary(const PlanReport& plan);
/// "out.0012.exr  640x360  1.2 s (shading 0.9)  180 000 pixels in gold, varnish"
std::string summary(const FrameReport& frame);

}  // namespace burnish
