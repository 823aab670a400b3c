// Shading with as many lookups a pixel as the light inside its lobe asks for.
//
// Every pixel is shaded with the fewest lookups first. They bring the light's second moment along, so they know the variance of one
// importance sample: where that is small they are the result, the others are shaded anew with as many as it asks for. Unlike the
// bound of Bandwidth IV.9, a sum of bandwidths times squared light, this is the variance of what is really done, sampling by
// the lobe; docs/measured.md compares both.
#pragma once

#include <burnish/sampling/sample_ladder.h>
#include <burnish/shading/table_shading.h>

#include <span>
#include <vector>

namespace burnish {

/// Tables of one lobe under one estimator, by number of lookups.
struct TableLadder {
    std::vector<TapTable> tables;  // as many as counts
    std::vector<int> counts;       // of lookups, ascending
    float full_deviation = 1;      // see sample_ladder.h
};

/// As add_table_shading, the table chosen pixel by pixel; shading.table is not read. samples[i] counts the lookups of the
/// prediction, too. `prediction`: what predicts, a table over a stack whose fourth channel holds squares; null: the lowest table
/// of the ladder, over such a stack. The same pixel gives the same bits in whatever batch it comes.
void add_adaptive_shading(const TableShading& shading, const TableLadder& ladder, const TableShading* prediction,
                          const SurfaceBatch& batch, std::span<Color3f> overlay, std::span<float> samples);

}  // namespace burnish
