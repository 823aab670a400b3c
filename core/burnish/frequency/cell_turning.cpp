#include <burnish/frequency/cell_turning.h>

#include <burnish/base/parallel.h>
#include <burnish/frequency/layer_change.h>
#include <burnish/frequency/turning_rows.h>

#include <cmath>
#include <limits>

namespace burnish {
namespace {

/// What rows are read from.
struct Pixels {
    const Image& normal;
    const Surfaces& surfaces;
    const Assignment& assignment;
    LayerChange layers;
};

/// A row of pixels and the squares along it; rows below the frame hold nothing valid.
struct ReadRow {
    explicit ReadRow(size_t width) : pixels(width), along(width + TurningRow::kPadding) {}

    void read(const Pixels& frame, int y, size_t width) {
        std::fill(pixels.key.begin(), pixels.key.end(), std::numeric_limits<float>::quiet_NaN());
        if (y < frame.normal.height) {
            const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(frame.normal.width);
            read_normals(frame.normal.at(begin), static_cast<size_t>(frame.normal.width), pixels);
            for (size_t x = 0; x < static_cast<size_t>(frame.normal.width); ++x)
                if (frame.surfaces.validity(begin + x) == Validity::valid)
                    pixels.key[x] = static_cast<float>(frame.assignment.rule[begin + x]);
        }
        compare_rows(pixels, pixels, 1, width, along.data());
        frame.layers.add(y, 1, 0, along.data());
    }

    TurningRow pixels;
    std::vector<float> along;
};

}  // namespace

CellTurning::CellTurning(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment, const PerPixel& used)
    : m_columns((assignment.width + kLargest - 1) / kLargest), m_rows((assignment.height + kLargest - 1) / kLargest) {
    for (int level = 0; level < kLevels; ++level)
        m_levels[static_cast<size_t>(level)].resize(static_cast<size_t>(columns(level)) * static_cast<size_t>(rows(level)));
    const Pixels pixels{frame.layer(Role::normal), surfaces, assignment,
                        LayerChange(frame, used, surfaces.roughness_is_alpha())};
    const size_t width = static_cast<size_t>(m_columns) * kLargest;
    for_each_index(m_rows, [&](int strip) {
        ReadRow here(width), below(width);
        std::vector<float> down(width + TurningRow::kPadding);
        here.read(pixels, strip * kLargest, width);
        for (int y = strip * kLargest; y < (strip + 1) * kLargest; ++y, std::swap(here, below)) {
            below.read(pixels, y + 1, width);
            compare_rows(here.pixels, below.pixels, 0, width, down.data());
            pixels.layers.add(y, 0, 1, down.data());
            down[width] = std::numeric_limits<float>::infinity();
            add_largest_sides(here.along.data(), below.along.data(), down.data(), width, cells(0, y / 2));
        }
        finish_strip(strip);
    });
}

/// Squares to angles, and the larger cells from the smallest.
void CellTurning::finish_strip(int strip) {
    const int cells_down = kLargest / cell_size(0);
    for (int row = strip * cells_down; row < (strip + 1) * cells_down; ++row) {
        float* turning = cells(0, row);
        for (int i = 0; i < columns(0); ++i) turning[i] = std::sqrt(turning[i]);
    }
    for (int level = 1; level < kLevels; ++level) {
        const int down = kLargest / cell_size(level);
        for (int row = strip * down; row < (strip + 1) * down; ++row) {
            const float *above = cells(level - 1, 2 * row), *below = cells(level - 1, 2 * row + 1);
            float* turning = cells(level, row);
            for (int i = 0; i < columns(level); ++i)
                turning[i] = std::max(std::max(above[2 * i], above[2 * i + 1]), std::max(below[2 * i], below[2 * i + 1]));
        }
    }
}

}  // namespace burnish
