// What a MERL table holds where nothing was measured: most of it below the horizon, some of it behind the rig.
//
// A hole takes the nearest measured values of its row on both sides round the circle of phi_d, each the more the nearer it is;
// a row without any copies the row of the next smaller theta_d, a plane without any the plane of the next smaller theta_h.
#pragma once

#include <burnish/base/types.h>

#include <vector>

namespace burnish {

/// The value that marks a hole.
inline const Color3f kHole(-1);

/// Fills the holes of a table's kCells values; all of them with black where nothing was measured at all.
void fill_holes(std::vector<Color3f>& cells);

}  // namespace burnish
