#include "demo_room_shot.h"
#include "demo_shot.h"

#include <burnish/job/stages.h>
#include <burnish/scene/demo_room.h>

#include <nlohmann/json.hpp>

namespace burnish::cli {
namespace {

constexpr float kLightMapShare = 0.5f;  // of the time

}  // namespace

BakeJob demo_room_job(const std::filesystem::path& folder, int width, int height) {
    BakeJob job;
    job.up = UpAxis::z;
    job.bake_light_maps = true;
    job.camera = camera_json(demo_room_viewpoint()).dump();
    job.width = width, job.height = height;
    for (const char* object :
         {"vase_chrome", "knot_gold", "bowl_aluminium", "ball_*", "box_lacquer", "ring_rubber", "table_*", "pane_*"})
        job.cubes.push_back({object, "", std::nullopt});
    job.mirrors = {{"floor_*", "floor", std::nullopt, false},
                   {"table_top", "", std::nullopt, false},
                   {"pane_clear", "", std::nullopt, true},
                   {"pane_frosted", "", std::nullopt, true}};
    job.panes = "pane_*";
    job.folder = folder.string();
    return job;
}

BakeReport write_demo_room_shot(const std::filesystem::path& folder, int width, int height, const Progress& progress) {
    BakeReport report;
    const BakeJob job = demo_room_job(folder, width, height);
    const BakeScene scene = light_bake_scene(make_demo_room(), job, part_of(progress, 0.0f, kLightMapShare), report);
    bake_pictures(job, scene, part_of(progress, kLightMapShare, 1.0f), report);
    return report;
}

}  // namespace burnish::cli
