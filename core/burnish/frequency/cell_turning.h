// How fast normals turn inside square cells of 2, 4, 8 and 16 pixels: what tells where a few pixels may stand for many.
//
// A cell of c pixels whose corner is (x, y), multiples of c, is [x, x + c] x [y, y + c], its far sides included, so that its four
// corners can stand for what lies between them. Where they cannot, because a material ends, a pixel is not valid, or the frame ends
// before the cell does, turning is infinite. Elsewhere normals within a cell differ by no more than turning times distance.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/surface/surfaces.h>

#include <burnish/base/pixel_vector.h>

#include <array>
#include <cstdint>
#include <vector>

namespace burnish {

/// Whether cells end where positions jump, see PositionStep: under light that is near, a table's edge and the floor behind it
/// reflect different things.
enum class AtSteps { go_on, end };

class CellTurning {
public:
    static constexpr int kLevels = 4, kLargest = 16;  // pixels
    static constexpr int cell_size(int level) { return 2 << level; }

    /// `used`: layers that some lobe reads. Where one of them jumps no cell goes across; a change of roughness counts as turning.
    CellTurning(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment, const PerPixel& used,
                AtSteps at_steps = AtSteps::go_on);

    /// Cells per row and column of a level; they cover the frame.
    int columns(int level) const { return m_columns << (kLevels - 1 - level); }
    int rows(int level) const { return m_rows << (kLevels - 1 - level); }
    /// Radian per pixel, or infinite; not to be asked of what is_empty.
    float at(int level, int column, int row) const { return cells(level, row)[column]; }

    /// Whether no pixel of a largest cell, its far sides apart, is valid.
    bool is_empty(int column, int row) const {
        return m_valid[static_cast<size_t>(row) * static_cast<size_t>(m_columns) + static_cast<size_t>(column)] == 0;
    }

private:
    struct Pixels;
    void note_valid(const Surfaces& surfaces, const Assignment& assignment, int strip);
    void fill_smallest(const Pixels& pixels, int strip, int begin, int end);
    void finish(int strip, int begin, int end);
    float* cells(int level, int row) {
        return &m_levels[static_cast<size_t>(level)][static_cast<size_t>(row) * static_cast<size_t>(columns(level))];
    }
    const float* cells(int level, int row) const { return const_cast<CellTurning*>(this)->cells(level, row); }

    int m_columns = 0, m_rows = 0;                     // of the largest cells
    std::array<PixelVector<float>, kLevels> m_levels;  // unset in empty cells
    std::vector<uint8_t> m_valid;                      // of the largest cells: some pixel is
};

}  // namespace burnish
