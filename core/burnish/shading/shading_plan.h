// Which pixels are shaded: cells of 1, 2, 4, 8 or 16 pixels, as large as the predicted bandwidth lets them be.
//
// A cell's corners are shaded and what lies between is interpolated, so a cell may be as large as its motion, the way that the
// reflected direction goes from one side to the other, stays a small part of a period of the overlay:
//
//     size * (2 * turning of normals + turning of the view) * nu_a  <=  kCellPeriods
//
// nu_a comes from a prediction at the cell's centre, coarse to fine: a cell too large for one prediction to hold all over it is
// split, and so is one that a material's border, an invalid pixel or the frame's edge crosses. Cells split down to pixels there.
#pragma once

#include <burnish/frequency/cell_turning.h>
#include <burnish/shading/predictor.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

class ShadingPlan {
public:
    static constexpr int kLargest = CellTurning::kLargest;
    static constexpr float kCellPeriods = 0.06f;  // of a display signal from black to white, across a cell; by calibration

    /// Pixels of rule i are predicted by predictors[i].
    ShadingPlan(const CellTurning& turning, const Surfaces& surfaces, const Assignment& assignment,
                std::span<const BandwidthPredictor> predictors);

    int columns() const { return m_columns; }  // of cells of two pixels; they cover the frame
    int rows() const { return m_rows; }
    /// Size of the cell that holds the 2 x 2 pixels from (2 i, 2 j) on: 1, 2, 4, 8 or 16. Beyond the frame's left and top edge
    /// the largest.
    int cell_size(int i, int j) const {
        return i < 0 || j < 0 ? kLargest
                              : m_sizes[static_cast<size_t>(j) * static_cast<size_t>(m_columns) + static_cast<size_t>(i)];
    }
    /// Whether a pixel is the corner of some cell.
    bool is_corner(int x, int y) const;

private:
    struct Planner;
    int m_columns, m_rows;
    std::vector<uint8_t> m_sizes;
};

}  // namespace burnish
