// Which pictures a bake makes: the names of a job resolved in its scene.
#pragma once

#include <burnish/job/bake_job.h>
#include <burnish/light/cube_map/bake_cube_map.h>
#include <burnish/scene/view.h>

namespace burnish {

struct PlannedCube {
    std::string name;          // of the light; <name>.exr is its file
    std::vector<int> objects;  // that it is for
    CubeMapView view;
};
struct PlannedMirror {
    std::string name;          // of the light; <name>.exr is its file
    std::vector<int> objects;  // that it is for
    MirrorSettings light;
    View view;
};
struct BakePlan {
    std::optional<View> frame;
    std::vector<PlannedCube> cubes;
    std::vector<PlannedMirror> mirrors;
};

/// Throws Error(bad_argument) for names that match nothing, names used twice, and cameras without rays.
BakePlan plan_bake(const BakeJob& job, const Scene& scene);

}  // namespace burnish
