// The way of `burnish bandwidth`: the frames of a job in, and for each what sparse shading would know of it.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/job.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

struct BandwidthReport {
    std::optional<int> frame;
    std::string input, output;
    std::string error;  // why it was skipped
    bool is_skipped = false;
    int width = 0, height = 0;
    size_t pixels = 0;           // with a prediction
    std::vector<size_t> levels;  // of them, by level
    double seconds = 0;          // reading, light and tables apart

    /// Samples that grids of these levels take: sum of pixels / 4^level.
    double grid_samples() const;
};

/// Writes Job::output.file (and .preview, see level_picture) for every frame, whole files or none, and .report at the end. Frames are
/// in memory whole; where there are finer AOVs, it is these that are predicted. Those that fail end the run or are passed over, as
/// the job says. Throws as `run` does.
std::vector<BandwidthReport> run_bandwidth(const Job& job, const Progress& progress);

/// "out.exr  640x360  0.31 s  50000 pixels, of which grids take 8.1 %: level 0 5.1 %, 1 7.0 %, 2 ..."
std::string summary(const BandwidthReport& report);
nlohmann::json report_to_json(const std::vector<BandwidthReport>& reports);

}  // namespace burnish
