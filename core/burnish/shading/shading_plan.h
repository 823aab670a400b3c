// Which pixels are shaded: cells of 1, 2, 4, 8 or 16 pixels, as large as the predicted bandwidth lets them be.
//
// A cell's corners are shaded and what lies between is interpolated, so a cell may be as large as its motion, the way that the
// reflected direction goes from one side to the other, stays a small part of a period of the overlay:
//
//     size * (2 * turning of normals + turning of the view + way across the ray * nearness) * nu_a  <=  kCellPeriods
//
// nu_a comes from a prediction at the cell's centre, coarse to fine: a cell too large for one prediction to hold all over it is
// split, and so is one that a material's border, an invalid pixel or the frame's edge crosses. Cells split down to pixels there.
// Where lights are near, one thing may hide another from one corner of a cell and not from the next, of which its centre knows
// nothing: there the corners are predicted too, and a cell whose corners' mean is not what its centre shows is split.
#pragma once

#include <burnish/frequency/cell_turning.h>
#include <burnish/shading/predictor.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

class ShadingPlan {
public:
    static constexpr int kBlock = CellTurning::kLargest;  // pixels; blocks are the largest cells

    /// Pixels of rule i are predicted by predictors[i].
    ShadingPlan(const CellTurning& turning, const Surfaces& surfaces, const Assignment& assignment,
                std::span<const BandwidthPredictor> predictors);

    int block_columns() const { return m_block_columns; }
    int block_rows() const { return m_block_rows; }
    /// Size of the cell that holds the 2 x 2 pixels from (2 i, 2 j) on: 1, 2, 4, 8 or 16. Beyond the frame, and where no pixel of
    /// a block is valid, the largest.
    int cell_size(int i, int j) const {
        const bool inside = i >= 0 && j >= 0 && i < m_columns && j < m_block_rows * kBlock / 2;
        return inside ? m_sizes[static_cast<size_t>(j) * static_cast<size_t>(m_columns) + static_cast<size_t>(i)] : kBlock;
    }

    /// Whether any pixel of a block is valid.
    bool is_empty(int column, int row) const { return m_turning.is_empty(column, row); }
    /// Which pixels of a block are corners of some cell, its neighbours' included: bit x of entry y. None of an empty block;
    /// the first one only beyond the frame.
    using Corners = std::array<uint16_t, kBlock>;
    const Corners& corners(int column, int row) const {
        static constexpr Corners kOutside{1};
        const bool inside = column < m_block_columns && row < m_block_rows;
        return inside ? m_corners[static_cast<size_t>(row) * static_cast<size_t>(m_block_columns) + static_cast<size_t>(column)]
                      : kOutside;
    }

private:
    struct Planner;
    bool is_dense(int i, int j) const;
    Corners find_corners(int column, int row) const;

    const CellTurning& m_turning;
    int m_block_columns, m_block_rows, m_columns;
    std::vector<uint8_t> m_sizes;
    std::vector<Corners> m_corners;
};

}  // namespace burnish
