#include <burnish/shading/shading_plan.h>

#include <burnish/base/parallel.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr float kDiagonal = 0.7071f;   // from a cell's centre to its corner, in sides
constexpr int kSmallestPredicted = 1;  // level of the cells of 4 pixels: predicting for 2 costs as much as shading them
constexpr int kTile = 8 * CellTurning::kLargest;

/// A cell of one level.
struct Cell {
    int level, column, row;

    int size() const { return CellTurning::cell_size(level); }
    Cell child(int k) const { return {level - 1, 2 * column + k % 2, 2 * row + k / 2}; }
};

}  // namespace

/// Plans one tile of the frame; tiles share nothing.
struct ShadingPlan::Planner {
    const CellTurning& turning;
    const Surfaces& surfaces;
    const Assignment& assignment;
    std::span<const BandwidthPredictor> predictors;
    ShadingPlan& plan;
    std::vector<Cell> cells, next;  // of one level: to be predicted; of the next one
    SurfaceBatch centres, neighbours;
    std::vector<AngularPrediction> predictions;

    void plan_tile(int first_column, int first_row) {
        const int across = kTile / CellTurning::kLargest, top = CellTurning::kLevels - 1;
        cells.clear();
        for (int row = first_row; row < std::min(first_row + across, turning.rows(top)); ++row)
            for (int column = first_column; column < std::min(first_column + across, turning.columns(top)); ++column)
                cells.push_back({top, column, row});
        for (int level = top; level >= kSmallestPredicted; --level, std::swap(cells, next)) plan_level();
    }

    /// Settles the cells that one prediction holds for; the others' quarters are next.
    void plan_level() {
        next.clear();
        std::vector<Cell> predictable;
        for (const Cell& cell : cells)
            if (std::isfinite(turning_of(cell)))
                predictable.push_back(cell);
            else
                split(cell);
        for (size_t rule = 0; rule < predictors.size(); ++rule) predict(static_cast<int>(rule), predictable);
    }

    float turning_of(const Cell& cell) const { return turning.at(cell.level, cell.column, cell.row); }
    uint32_t centre_of(const Cell& cell) const {
        const int half = cell.size() / 2, x = cell.column * cell.size() + half, y = cell.row * cell.size() + half;
        return static_cast<uint32_t>(y) * static_cast<uint32_t>(assignment.width) + static_cast<uint32_t>(x);
    }

    void predict(int rule, const std::vector<Cell>& predictable) {
        std::vector<Cell> own;
        centres.clear(), neighbours.clear();
        for (const Cell& cell : predictable) {
            const uint32_t pixel = centre_of(cell);
            if (assignment.rule[pixel] != rule) continue;
            own.push_back(cell);
            centres.pixel.push_back(pixel);
            neighbours.pixel.push_back(pixel + 1), neighbours.pixel.push_back(pixel + static_cast<uint32_t>(assignment.width));
        }
        if (own.empty()) return;
        surfaces.fill(centres), surfaces.fill(neighbours);
        predictions.resize(own.size());
        predictors[static_cast<size_t>(rule)].predict(centres, predictions);
        for (size_t i = 0; i < own.size(); ++i) {
            const AngularPrediction& p = predictions[i];
            const float others = std::max(change_to(2 * i, i, p.length), change_to(2 * i + 1, i, p.length));
            const float motion = 2 * turning_of(own[i]) + others;
            if (static_cast<float>(own[i].size()) * motion * kDiagonal <= p.reach)
                settle(own[i], p.nu_a, others);
            else
                split(own[i]);
        }
    }

    /// Radian per pixel that the view turns, and the lobe's far end with its tangent, from a centre to its neighbour.
    float change_to(size_t neighbour, size_t centre, float length) const {
        float change = (neighbours.wo[neighbour] - centres.wo[centre]).length();
        if (length > 0) change += length * (neighbours.t[neighbour] - centres.t[centre]).length();
        return change;
    }

    void split(const Cell& cell) {
        if (cell.level == kSmallestPredicted) return set_size(cell, 1);
        for (int k = 0; k < 4; ++k) next.push_back(cell.child(k));
    }

    /// Makes the cell as large as nu_a lets it, or else its quarters.
    void settle(const Cell& cell, float nu_a, float others) {
        const float motion = 2 * turning_of(cell) + others;
        if (static_cast<float>(cell.size()) * motion * nu_a <= kCellPeriods) return set_size(cell, cell.size());
        if (cell.level == 0) return set_size(cell, 1);
        for (int k = 0; k < 4; ++k) settle(cell.child(k), nu_a, others);
    }

    void set_size(const Cell& cell, int size) {
        const int across = cell.size() / 2;
        for (int j = cell.row * across; j < (cell.row + 1) * across; ++j)
            std::fill_n(&plan.m_sizes[static_cast<size_t>(j) * static_cast<size_t>(plan.m_columns) +
                                      static_cast<size_t>(cell.column * across)],
                        across, static_cast<uint8_t>(size));
    }
};

ShadingPlan::ShadingPlan(const CellTurning& turning, const Surfaces& surfaces, const Assignment& assignment,
                         std::span<const BandwidthPredictor> predictors)
    : m_columns(turning.columns(0)), m_rows(turning.rows(0)), m_sizes(static_cast<size_t>(m_columns) * m_rows) {
    const int top = CellTurning::kLevels - 1, across = kTile / CellTurning::kLargest;
    const int tiles_across = (turning.columns(top) + across - 1) / across,
              tiles_down = (turning.rows(top) + across - 1) / across;
    for_each_index(tiles_across * tiles_down, [&](int tile) {
        Planner{turning, surfaces, assignment, predictors, *this, {}, {}, {}, {}, {}}.plan_tile(tile % tiles_across * across,
                                                                                                tile / tiles_across * across);
    });
}

bool ShadingPlan::is_corner(int x, int y) const {
    const int i = x / 2, j = y / 2, left = (x - 1) >> 1, above = (y - 1) >> 1;
    const int smallest = std::min({cell_size(i, j), cell_size(left, j), cell_size(i, above), cell_size(left, above)});
    return ((x | y) & (smallest - 1)) == 0;
}

}  // namespace burnish
