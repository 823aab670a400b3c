#include <burnish/frequency/cell_turning.h>

#include <burnish/base/parallel.h>
#include <burnish/frequency/layer_change.h>
#include <burnish/frequency/position_step.h>
#include <burnish/frequency/turning_rows.h>

#include <cmath>
#include <limits>

namespace burnish {

/// What rows are read from.
struct CellTurning::Pixels {
    const Image& normal;
    const Surfaces& surfaces;
    const Assignment& assignment;
    LayerChange layers;
    PositionStep steps;

    void add_changes(int y, int first, int count, int dx, int dy, float* squares) const {
        layers.add(y, first, count, dx, dy, squares);
        steps.add(y, first, count, dx, dy, squares);
    }
};

namespace {

/// Some pixels of a row and the squares along it; rows below the frame hold nothing valid.
struct ReadRow {
    explicit ReadRow(size_t width) : pixels(width), along(width + TurningRow::kPadding) {}

    /// Pixels [first, first + width], the last one for its neighbour's sake.
    template <class Pixels>
    void read(const Pixels& frame, int y, int first, int width) {
        const int count = y < frame.normal.height ? std::min(width + 1, frame.normal.width - first) : 0;
        std::fill(pixels.key.begin() + count, pixels.key.end(), std::numeric_limits<float>::quiet_NaN());
        if (count > 0) {
            const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(frame.normal.width) + static_cast<size_t>(first);
            read_normals(frame.normal.at(begin), static_cast<size_t>(count), pixels);
            for (size_t x = 0; x < static_cast<size_t>(count); ++x)
                pixels.key[x] = frame.surfaces.validity(begin + x) == Validity::valid
                                    ? static_cast<float>(frame.assignment.rule[begin + x])
                                    : std::numeric_limits<float>::quiet_NaN();
        }
        compare_rows(pixels, pixels, 1, static_cast<size_t>(width), along.data());
        frame.add_changes(y, first, width, 1, 0, along.data());
    }

    TurningRow pixels;
    std::vector<float> along;
};

}  // namespace

CellTurning::CellTurning(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment, const PerPixel& used,
                         AtSteps at_steps)
    : m_columns((assignment.width + kLargest - 1) / kLargest),
      m_rows((assignment.height + kLargest - 1) / kLargest),
      m_valid(static_cast<size_t>(m_columns) * static_cast<size_t>(m_rows)) {
    for (int level = 0; level < kLevels; ++level)
        m_levels[static_cast<size_t>(level)].resize(static_cast<size_t>(columns(level)) * static_cast<size_t>(rows(level)));
    const Pixels pixels{frame.layer(Role::normal), surfaces, assignment,
                        LayerChange(frame, used, surfaces.roughness_is_alpha()),
                        at_steps == AtSteps::end ? PositionStep(frame) : PositionStep()};
    for_each_index(m_rows, [&](int strip) {
        note_valid(surfaces, assignment, strip);
        for (int begin = 0, end; begin < m_columns; begin = end) {
            for (end = begin; end < m_columns && !is_empty(end, strip);) ++end;
            if (end > begin)
                fill_smallest(pixels, strip, begin, end), finish(strip, begin, end);
            else
                ++end;
        }
    });
}

void CellTurning::note_valid(const Surfaces& surfaces, const Assignment& assignment, int strip) {
    for (int y = strip * kLargest; y < std::min((strip + 1) * kLargest, assignment.height); ++y)
        for (int column = 0; column < m_columns; ++column) {
            const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(assignment.width);
            const int first = column * kLargest, last = std::min(first + kLargest, assignment.width);
            uint8_t& valid = m_valid[static_cast<size_t>(strip) * static_cast<size_t>(m_columns) + static_cast<size_t>(column)];
            valid |= surfaces.any_valid(begin + static_cast<size_t>(first), static_cast<size_t>(last - first));
        }
}

/// The smallest cells, squared, of columns [begin, end) of largest ones.
void CellTurning::fill_smallest(const Pixels& pixels, int strip, int begin, int end) {
    const int first = begin * kLargest, width = (end - begin) * kLargest;
    for (int row = strip * kLargest / 2; row < (strip + 1) * kLargest / 2; ++row)
        std::fill_n(cells(0, row) + first / 2, width / 2, 0.0f);
    const auto count = static_cast<size_t>(width);
    ReadRow here(count), below(count);
    std::vector<float> down(count + TurningRow::kPadding);
    here.read(pixels, strip * kLargest, first, width);
    for (int y = strip * kLargest; y < (strip + 1) * kLargest; ++y, std::swap(here, below)) {
        below.read(pixels, y + 1, first, width);
        compare_rows(here.pixels, below.pixels, 0, count + 1, down.data());
        pixels.add_changes(y, first, width + 1, 0, 1, down.data());
        add_largest_sides(here.along.data(), below.along.data(), down.data(), count, cells(0, y / 2) + first / 2);
    }
}

/// Squares to angles, and the larger cells from the smallest.
void CellTurning::finish(int strip, int begin, int end) {
    const auto rows_of = [&](int level, const auto& work) {
        const int size = cell_size(level), per_cell = kLargest / size;
        for (int row = strip * per_cell; row < (strip + 1) * per_cell; ++row) work(row, begin * per_cell, end * per_cell);
    };
    rows_of(0, [&](int row, int first, int last) {
        float* turning = cells(0, row);
        for (int i = first; i < last; ++i) turning[i] = std::sqrt(turning[i]);
    });
    for (int level = 1; level < kLevels; ++level)
        rows_of(level, [&](int row, int first, int last) {
            const float *above = cells(level - 1, 2 * row), *below = cells(level - 1, 2 * row + 1);
            float* turning = cells(level, row);
            for (int i = first; i < last; ++i)
                turning[i] = std::max(std::max(above[2 * i], above[2 * i + 1]), std::max(below[2 * i], below[2 * i + 1]));
        });
}

}  // namespace burnish
