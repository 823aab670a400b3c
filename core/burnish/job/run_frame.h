// One frame in memory: the one implementation behind files and arrays.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/look.h>
#include <burnish/output/report.h>
#include <burnish/shading/dense.h>

#include <set>

namespace burnish {

struct FrameResult {
    Composite composite;
    ShadedFrame shaded;
    Image validity;  // 1 channel: the number of each pixel's Validity
    FrameReport report;
};

/// The roles a job reads when the frame has them. `without_beauty`: also what the diffuse part is made of.
std::set<Role> wanted_roles(const Job& job, const Wardrobe& wardrobe, bool without_beauty);

/// Surfaces, shading and compositing of a frame. `assignment`: who wears what; null = by the rules.
/// Throws Error(missing_channel | size_mismatch | color_space | cancelled).
FrameResult run_frame(const Job& job, const AovFrame& frame, const Look& look, const Assignment* assignment,
                      const Progress& progress);

/// Assignment from one mask per rule (1 channel, coverage in [0, 1], 0 = not this material); later masks win.
/// Throws Error(size_mismatch).
Assignment assign_masks(const std::vector<Image>& masks);

}  // namespace burnish
