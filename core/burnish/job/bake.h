// burnish bake: a scene seen from where its objects are. Cube maps, pictures in mirrors and behind panes, AOVs of a camera, and a
// shot file that names them all as lights.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/bake_job.h>
#include <burnish/light/traced/lit_scene.h>
#include <burnish/output/report.h>

#include <memory>

namespace burnish {

struct BakeReport {
    NamedValues<double> seconds;     // wall time by stage, in the order they ran
    std::vector<std::string> files;  // that were written, names in the folder; shot.json is the last
};

/// What is baked, and how the shot file names it.
struct BakeScene {
    std::shared_ptr<const LitScene> lit;
    TracedSettings files;
};

/// Reads the scene of the job and its light maps, or bakes those. Throws Error.
BakeScene load_bake_scene(const BakeJob& job, const Progress& progress, BakeReport& report);

/// For a scene without light maps: gives it new texture coordinates, bakes the light of its own lamps, and writes scene.glb and
/// irradiance.exr to the folder. Throws Error.
BakeScene light_bake_scene(Scene scene, const BakeJob& job, const Progress& progress, BakeReport& report);

/// Writes cube_NAME.exr, mirror_NAME.exr, behind_NAME.exr and shot.exr to the folder of the job, and when all are there shot.json.
/// Objects that name a preset wear it. Same bits for any thread count. Throws Error.
void bake_pictures(const BakeJob& job, const BakeScene& scene, const Progress& progress, BakeReport& report);

/// The whole job.
BakeReport bake(const BakeJob& job, const Progress& progress);

}  // namespace burnish
