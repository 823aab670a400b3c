// burnish bake: a scene seen from where its objects are. Cube maps, mirror pictures, AOVs of a camera, and a shot file that names
// them all as lights.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/bake_job.h>
#include <burnish/output/report.h>
#include <burnish/scene/surface_light.h>

namespace burnish {

/// What is baked: a scene with its light, and how the shot file names both.
struct BakeScene {
    Scene scene;
    LightMaps maps;
    TracedSettings files;  // relative to the folder of the bake, or absolute
};

struct BakeReport {
    NamedValues<double> seconds;     // wall time by stage, in the order they ran
    std::vector<std::string> files;  // written, by name in the folder; shot.json is the last
};

/// Loads the scene of the job and its light maps, or bakes those and writes both to the folder.
BakeScene load_bake_scene(const BakeJob& job, const Progress& progress, BakeReport& report);

/// Light maps for a scene that has none: new texture coordinates, a map of the light of its lamps, and files of both.
BakeScene light_scene(Scene scene, const BakeJob& job, const Progress& progress, BakeReport& report);

/// Writes cube_NAME.exr, mirror_NAME.exr, behind_NAME.exr, shot.exr and shot.json to the folder of the job. Materials are those
/// presets that objects name. Same bits for any thread count. Throws Error; files that were written before stay, shot.json is
/// written when all others are.
void bake_pictures(const BakeJob& job, const BakeScene& scene, const Progress& progress, BakeReport& report);

/// Both for a job.
BakeReport bake(const BakeJob& job, const Progress& progress);

}  // namespace burnish
