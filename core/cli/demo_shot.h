// The shot of `burnish demo`: traces its scene and leaves the files a renderer and an artist would have left.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/output/report.h>
#include <burnish/scene/demo_scene.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace burnish::cli {

/// The camera as shot files spell it.
nlohmann::ordered_json camera_json(const Viewpoint& view);

/// Writes shot.exr (all AOVs, names of Cycles), sky.exr and shot.json into `folder`; adds wall times by stage to `seconds`.
/// Throws Error(write_failed).
void write_demo_shot(const std::filesystem::path& folder, int width, int height, const Progress& progress,
                     NamedValues<double>& seconds);

}  // namespace burnish::cli
