#include <burnish/shading/shading_plan.h>

#include <burnish/base/parallel.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace burnish {
namespace {

constexpr float kDiagonal = 0.7071f;  // from a cell's centre to its corner, in sides
constexpr int kTop = CellTurning::kLevels - 1;
constexpr int kSmallestAlone = 1;  // level of 4 pixels: at edges smaller cells are not worth a prediction of their own
constexpr int kTile = 8;           // blocks a side that are planned at once
constexpr float kUnknown = std::numeric_limits<float>::infinity();

/// A cell of one level, and what the prediction for the larger one that it is part of found, if there was one.
struct Cell {
    int level, column, row;
    float reach = kUnknown, others = 0;  // others: motion besides the normals', radian per pixel

    int size() const { return CellTurning::cell_size(level); }
    Cell child(int k) const { return {level - 1, 2 * column + k % 2, 2 * row + k / 2, reach, others}; }
};

}  // namespace

/// Plans tiles of the frame one after the other; tiles share nothing.
struct ShadingPlan::Planner {
    const Surfaces& surfaces;
    const Assignment& assignment;
    std::span<const BandwidthPredictor> predictors;
    ShadingPlan& plan;
    std::vector<Cell> cells = {}, next = {}, own = {};  // of one level: to be settled; of the next one; of one rule
    SurfaceBatch centres = {}, neighbours = {};
    std::vector<AngularPrediction> predictions = {}, found = {}, at_corners = {};
    std::unordered_map<uint32_t, AngularPrediction> known = {};  // corners of the tile

    void plan_tile(int first_column, int first_row) {
        cells.clear(), known.clear();
        for (int row = first_row; row < std::min(first_row + kTile, plan.m_block_rows); ++row)
            for (int column = first_column; column < std::min(first_column + kTile, plan.m_block_columns); ++column)
                if (plan.is_empty(column, row))
                    set_size({kTop, column, row}, kBlock);
                else if (is_broken(column, row))
                    set_size({kTop, column, row}, 1);
                else
                    cells.push_back({kTop, column, row});
        for (; !cells.empty(); std::swap(cells, next)) plan_level();
    }

    /// Whether something crosses every cell of a block that is worth a prediction.
    bool is_broken(int column, int row) const {
        constexpr int across = kBlock / CellTurning::cell_size(kSmallestAlone);
        for (int j = row * across; j < (row + 1) * across; ++j)
            for (int i = column * across; i < (column + 1) * across; ++i)
                if (std::isfinite(plan.m_turning.at(kSmallestAlone, i, j))) return false;
        return true;
    }

    /// Settles the cells that one prediction holds for; the others' quarters are next.
    void plan_level() {
        next.clear();
        std::erase_if(cells, [&](const Cell& cell) {
            const bool is_predictable = motion_of(cell) * extent_of(cell) <= cell.reach && std::isfinite(turning_of(cell));
            if (!is_predictable) split(cell);
            return !is_predictable;
        });
        for (size_t rule = 0; rule < predictors.size(); ++rule) predict(static_cast<int>(rule));
    }

    float turning_of(const Cell& cell) const { return plan.m_turning.at(cell.level, cell.column, cell.row); }
    float motion_of(const Cell& cell) const { return 2 * turning_of(cell) + cell.others; }
    static float extent_of(const Cell& cell) { return kDiagonal * static_cast<float>(cell.size()); }
    uint32_t corner_of(const Cell& cell) const {
        return static_cast<uint32_t>(cell.row * cell.size()) * static_cast<uint32_t>(assignment.width) +
               static_cast<uint32_t>(cell.column * cell.size());
    }
    uint32_t centre_of(const Cell& cell) const {
        return corner_of(cell) + static_cast<uint32_t>(cell.size() / 2 * (assignment.width + 1));
    }

    void predict(int rule) {
        own.clear(), centres.clear();
        for (const Cell& cell : cells) {
            const uint32_t pixel = centre_of(cell);
            if (assignment.rule[pixel] == rule) own.push_back(cell), centres.pixel.push_back(pixel);
        }
        if (own.empty()) return;
        const BandwidthPredictor& predictor = predictors[static_cast<size_t>(rule)];
        const BatchNeeds needs = predictor.needs();
        surfaces.fill(centres, needs);
        if (!centres.roughness.empty()) take_sharpest();
        predictions.resize(own.size());
        predictor.predict(centres, predictions);
        if (predictor.is_near()) look_at_corners(predictor);
        add_other_motion(needs);
        for (size_t i = 0; i < own.size(); ++i) {
            own[i].reach = predictions[i].reach;
            if (motion_of(own[i]) * extent_of(own[i]) <= own[i].reach && !(predictor.is_near() && is_missed(i, predictor)))
                settle(own[i], predictions[i].nu_a);
            else
                split(own[i]);
        }
    }

    void list_corners() {
        neighbours.clear();
        for (const Cell& cell : own)
            for (const int down : {0, cell.size()})
                for (const int right : {0, cell.size()})
                    neighbours.pixel.push_back(corner_of(cell) + static_cast<uint32_t>(down * assignment.width + right));
    }

    /// Where lights are near, what a centre sees may be hidden from a corner: the faster of both counts. Cells share corners.
    void look_at_corners(const BandwidthPredictor& predictor) {
        list_corners();
        const std::vector<uint32_t> corners = neighbours.pixel;
        neighbours.clear();
        for (const uint32_t pixel : corners)
            if (known.try_emplace(pixel).second) neighbours.pixel.push_back(pixel);
        surfaces.fill(neighbours, predictor.needs());
        found.resize(neighbours.size());
        predictor.predict(neighbours, found);
        for (size_t k = 0; k < found.size(); ++k) known[neighbours.pixel[k]] = found[k];
        at_corners.clear();
        for (const uint32_t pixel : corners) at_corners.push_back(known[pixel]);
        for (size_t k = 0; k < at_corners.size(); ++k) {
            AngularPrediction& centre = predictions[k / 4];
            centre.nu_a = std::max(centre.nu_a, at_corners[k].nu_a);
            centre.nearness = std::max(centre.nearness, at_corners[k].nearness);
            centre.reach = std::min(centre.reach, at_corners[k].reach);
        }
    }

    /// Whether the mean of a cell's corners is not what its centre shows.
    bool is_missed(size_t i, const BandwidthPredictor& predictor) const {
        const AngularPrediction* corners = &at_corners[4 * i];
        const float mean = 0.25f * (corners[0].shown + corners[1].shown + corners[2].shown + corners[3].shown);
        return std::fabs(predictions[i].shown - mean) * predictor.safety() * predictor.safety() > kMostMissed;
    }

    /// The centres stand for cells where the lobe may be narrower: take the least roughness of centre and corners.
    void take_sharpest() {
        list_corners();
        surfaces.fill(neighbours, {false, false});
        for (size_t i = 0; i < own.size(); ++i)
            for (size_t k = 4 * i; k < 4 * i + 4; ++k)
                centres.roughness[i] = std::min(centres.roughness[i], neighbours.roughness[k]);
    }

    /// Radian per pixel that the view turns, the lobe's far end with its tangent, and what is near as the point moves, from the
    /// centres to their neighbours. What was found for a larger cell holds for its parts.
    void add_other_motion(const BatchNeeds& needs) {
        neighbours.clear();
        for (size_t i = 0; i < own.size(); ++i)
            if (own[i].reach == kUnknown)
                for (const int step : {1, assignment.width})
                    neighbours.pixel.push_back(centres.pixel[i] + static_cast<uint32_t>(step));
        if (neighbours.pixel.empty()) return;
        surfaces.fill(neighbours, needs);
        for (size_t i = 0, k = 0; i < own.size(); ++i) {
            if (own[i].reach != kUnknown) continue;
            for (int side = 0; side < 2; ++side, ++k) {
                float change = (neighbours.wo[k] - centres.wo[i]).length();
                if (predictions[i].nearness > 0) change += predictions[i].nearness * step_across(i, k);
                if (const float length = predictions[i].length; length > 0) {
                    change += length * (neighbours.t[k] - centres.t[i]).length();
                    if (!centres.rotation.empty()) change += length * std::fabs(neighbours.rotation[k] - centres.rotation[i]);
                }
                own[i].others = std::max(own[i].others, change);
            }
        }
    }

    /// The way from a centre to a neighbour across the view, which is across the mirrored view, too, as both lie on the surface.
    float step_across(size_t centre, size_t neighbour) const {
        const Vec3f step = neighbours.p[neighbour] - centres.p[centre], wo = centres.wo[centre];
        return (step - wo * step.dot(wo)).length();
    }

    void split(const Cell& cell) {
        if (cell.level == 0 || (cell.level == kSmallestAlone && cell.reach == kUnknown)) return set_size(cell, 1);
        for (int k = 0; k < 4; ++k) next.push_back(cell.child(k));
    }

    /// Makes the cell as large as nu_a lets it, or else its quarters.
    void settle(const Cell& cell, float nu_a) {
        if (static_cast<float>(cell.size()) * motion_of(cell) * nu_a <= kCellPeriods) return set_size(cell, cell.size());
        if (cell.level == 0) return set_size(cell, 1);
        for (int k = 0; k < 4; ++k) settle(cell.child(k), nu_a);
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
    : m_turning(turning),
      m_block_columns(turning.columns(kTop)),
      m_block_rows(turning.rows(kTop)),
      m_columns(turning.columns(0)),
      m_sizes(static_cast<size_t>(m_columns) * static_cast<size_t>(turning.rows(0))),
      m_corners(static_cast<size_t>(m_block_columns) * static_cast<size_t>(m_block_rows)) {
    tbb::enumerable_thread_specific<Planner> planners([&] { return Planner{surfaces, assignment, predictors, *this}; });
    const int tiles_across = (m_block_columns + kTile - 1) / kTile, tiles_down = (m_block_rows + kTile - 1) / kTile;
    for_each_index(tiles_across * tiles_down,
                   [&](int tile) { planners.local().plan_tile(tile % tiles_across * kTile, tile / tiles_across * kTile); });
    for_each_index(m_block_rows, [&](int row) {
        for (int column = 0; column < m_block_columns; ++column)
            m_corners[static_cast<size_t>(row) * static_cast<size_t>(m_block_columns) + static_cast<size_t>(column)] =
                find_corners(column, row);
    });
}

/// Whether the cells of a block are all of one pixel; (i, j) is its first.
bool ShadingPlan::is_dense(int i, int j) const {
    for (int row = j; row < j + kBlock / 2; ++row) {
        const uint8_t* sizes = &m_sizes[static_cast<size_t>(row) * static_cast<size_t>(m_columns) + static_cast<size_t>(i)];
        if (std::any_of(sizes, sizes + kBlock / 2, [](uint8_t size) { return size != 1; })) return false;
    }
    return true;
}

ShadingPlan::Corners ShadingPlan::find_corners(int column, int row) const {
    Corners corners{};
    if (is_empty(column, row)) return corners;
    const int i0 = column * kBlock / 2, j0 = row * kBlock / 2;
    if (is_dense(i0, j0)) {
        corners.fill(0xffff);
        return corners;
    }
    for (int j = 0; j < kBlock / 2; ++j) {
        uint32_t even = 0, odd = 0;  // rows 2 j and 2 j + 1
        for (int i = 0; i < kBlock / 2; ++i) {
            const int own = cell_size(i0 + i, j0 + j), left = std::min(own, cell_size(i0 + i - 1, j0 + j)),
                      above = std::min(own, cell_size(i0 + i, j0 + j - 1)),
                      smallest = std::min({left, above, cell_size(i0 + i - 1, j0 + j - 1)});
            even |= static_cast<uint32_t>(((2 * i | 2 * j) & (smallest - 1)) == 0) << (2 * i);
            even |= static_cast<uint32_t>(above == 1) << (2 * i + 1);
            odd |= static_cast<uint32_t>(left == 1) << (2 * i) | static_cast<uint32_t>(own == 1) << (2 * i + 1);
        }
        corners[static_cast<size_t>(2 * j)] = static_cast<uint16_t>(even);
        corners[static_cast<size_t>(2 * j + 1)] = static_cast<uint16_t>(odd);
    }
    return corners;
}

}  // namespace burnish
