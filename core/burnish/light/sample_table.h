// A piecewise constant density over a grid, drawn from by inverting its cumulative sums (Pharr et al., Physically Based
// Rendering, 2D piecewise-constant distributions).
#pragma once

#include <burnish/base/types.h>

#include <vector>

namespace burnish {

class SampleTable {
public:
    SampleTable() = default;
    /// `weights`: height x width, row-major, >= 0, finite; all zero counts as all one.
    SampleTable(int width, int height, std::vector<double> weights);

    int width() const { return m_width; }
    int height() const { return static_cast<int>(m_rows.size()); }

    /// A place in the grid, (column + fraction, row + fraction), for u in [0, 1)^2.
    struct Place {
        int column, row;
        float x, y;  // inside the cell, [0, 1)
    };
    Place sample(const Vec2f& u) const;

    /// Probability of a cell; all sum to 1.
    double probability(int column, int row) const;

private:
    int m_width = 0;
    std::vector<double> m_columns;  // running sums along each row
    std::vector<double> m_rows;     // running sums of the rows' totals
};

}  // namespace burnish
