// The shot file of a bake: all that was baked, as lights, and who is lit by what.
#pragma once

#include <burnish/job/bake.h>
#include <burnish/job/bake_plan.h>

namespace burnish {

/// JSON text. Files are named relative to the folder of the job, the scene's own by absolute paths. Objects that name a preset wear
/// it, lit by their own mirror or pane, then their own cube map or, without one, by the traced scene.
std::string baked_shot(const BakeJob& job, const BakePlan& plan, const BakeScene& scene);

}  // namespace burnish
