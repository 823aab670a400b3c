// The shot of `burnish demo`: traces its scene and leaves the files a renderer and an artist would have left.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/frame.h>
#include <burnish/output/report.h>

#include <filesystem>

namespace burnish::cli {

/// Writes shot.exr (all AOVs, names of Cycles), sky.exr and shot.json into `folder`; adds wall times by stage to `seconds`.
/// Returns the frame as traced. Throws Error(write_failed).
AovFrame write_demo_shot(const std::filesystem::path& folder, int width, int height, const Progress& progress,
                         NamedValues<double>& seconds);

}  // namespace burnish::cli
