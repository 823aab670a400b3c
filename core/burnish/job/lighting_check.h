// How far factored lighting is from what it stands for, told without the samples that it was made from.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/factor/stored_factors.h>
#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>

namespace burnish {

/// Display PSNR (compare.h) against the estimator `reference` at `pairs` of normal and view, drawn as often as they are seen on whatever
/// is convex and looked at from all sides. The reference's own noise is some 50 dB. Same value for any thread count. Throws
/// Error(cancelled).
double lighting_psnr_db(const StoredFactors& stored, const Material& material, const Environment& light, int pairs,
                        const Progress& progress);

}  // namespace burnish
