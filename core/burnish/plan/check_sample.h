// Which pixels an estimate is checked at: many where two estimators disagree, few where they agree, and each counts for so many more.
//
// Errors sit in few pixels, near the horizon and where lamps are seen; a few hundred pixels drawn evenly may miss them all and promise
// ten dB too much. Where estimators err, they mostly err differently, so the square of their difference over some thousand pixels, which
// costs next to nothing, is what to draw by.
#pragma once

#include <burnish/shading/material_shader.h>
#include <burnish/surface/surfaces.h>

#include <cstdint>
#include <vector>

namespace burnish {

struct CheckSample {
    std::vector<uint32_t> pixels;
    std::vector<double> weights;  // the share of the material's pixels that each stands for: they sum to about 1
    double exposure = 0;          // shows the mean of all its pixels at 0.18; 0: as the truth at these pixels has it
};

/// One pixel at random from each of `count` equal parts of the rule's pixels, row by row: whatever the light.
CheckSample spread_sample(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count);

/// Two estimators to draw by.
struct Disagreement {
    const MaterialShader &one, &other;
};

/// `count` valid pixels of `rule` (all, if there are no more), the same for the same frame.
CheckSample check_sample(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count,
                         const Disagreement& by);

/// Batches of a few pixels each, to be shaded by all threads, with the fields that `shader` needs.
std::vector<SurfaceBatch> small_batches(const Surfaces& surfaces, const std::vector<uint32_t>& pixels,
                                        const MaterialShader& shader);
/// What shows the mean of these colours at 0.18, each by its weight.
double exposure_of(const std::vector<Color3f>& picture, const std::vector<double>& weights);
/// All of them, one after the other.
ShadedBatch shade_all(const std::vector<SurfaceBatch>& batches, const MaterialShader& shader);

}  // namespace burnish
