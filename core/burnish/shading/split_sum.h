// The `split_sum` estimator, what real-time engines do (Karis 2013): light filtered once by the lobe as seen from above, read
// once per pixel in the mirror direction, times the lobe's directional albedo. Here as the peer to measure against.
//
// It takes the lobe for round and upright at every view, which is exact from above and wrong by the whole stretch of the
// reflection at grazing angles; anisotropic lobes are taken for round ones of their mean width.
#pragma once

#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/shading/tap_table.h>

namespace burnish {

struct SplitSum {
    TapTable table;      // one tap; its level is that of `filtered`
    CubeStack filtered;  // a level for each width of the table
};

/// For a lobe that TapTable::covers.
SplitSum split_sum(const LobeParameters& lobe, const GaussianStack& light);

}  // namespace burnish
