// Sparse shading: as many pixels as the predicted bandwidth asks for, the others interpolated.
//
//     CellTurning    how fast normals turn, every pixel read once
//     ShadingPlan    cells, as large as the predicted bandwidth lets them be
//     shade          the cells' corners, with their own normals
//     upsample       what lies between
//
// Each step runs tile by tile and looks at most 16 pixels beyond its tile at what the step before it made.
#pragma once

#include <burnish/shading/dense.h>
#include <burnish/shading/predictor.h>

namespace burnish {

/// Shades pixels of rule i with shaders[i] where predictors[i] asks for it. `samples` and `standard_error` are 0 where a pixel was
/// interpolated. Bit-identical for any thread count.
ShadedFrame shade_sparse(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment,
                         const std::vector<MaterialShader>& shaders, const std::vector<BandwidthPredictor>& predictors,
                         const Progress& progress, bool with_samples = false);

}  // namespace burnish
