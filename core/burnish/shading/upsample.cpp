#include <burnish/shading/upsample.h>

#include <burnish/base/parallel.h>

#include <algorithm>
#include <array>
#include <bit>

namespace burnish {
namespace {

constexpr int kBlock = ShadingPlan::kBlock;

/// What of a block of 16 x 16 pixels and its far sides is shaded; bit x of entry y.
struct BlockCorners {
    std::array<uint32_t, kBlock + 1> rows;

    BlockCorners(const ShadingPlan& plan, int column, int row) {
        const ShadingPlan::Corners &own = plan.corners(column, row), &right = plan.corners(column + 1, row),
                                   &below = plan.corners(column, row + 1), &beyond = plan.corners(column + 1, row + 1);
        for (size_t y = 0; y < kBlock; ++y) rows[y] = own[y] | (right[y] & 1u) << kBlock;
        rows[kBlock] = below[0] | (beyond[0] & 1u) << kBlock;
    }

    bool is_one_cell() const {
        constexpr uint32_t ends = 1u | 1u << kBlock;
        uint32_t others = rows[0] ^ ends;
        for (size_t y = 1; y < kBlock; ++y) others |= rows[y];
        return (others | (rows[kBlock] & ~ends)) == 0;
    }
    bool is_shaded() const {
        uint32_t all = kOwn;
        for (size_t y = 0; y < kBlock; ++y) all &= rows[y];
        return all == kOwn;
    }
    static constexpr uint32_t kOwn = (1u << kBlock) - 1;
};

/// Bilinear between the four corners of a block, whose far ones belong to the next blocks.
void fill_block(int x0, int y0, Image& rgb) {
    const float *top_left = rgb.at(x0, y0), *top_right = rgb.at(x0 + kBlock, y0), *bottom_left = rgb.at(x0, y0 + kBlock),
                *bottom_right = rgb.at(x0 + kBlock, y0 + kBlock);
    std::array<float, 3 * kBlock> top, slope;
    for (int x = 0; x < kBlock; ++x)
        for (int k = 0; k < 3; ++k) {
            const float part = static_cast<float>(x) / kBlock;
            const auto i = static_cast<size_t>(3 * x + k);
            top[i] = top_left[k] + part * (top_right[k] - top_left[k]);
            slope[i] = (bottom_left[k] + part * (bottom_right[k] - bottom_left[k]) - top[i]) / kBlock;
        }
    for (int y = 0; y < kBlock; ++y) {
        float* row = rgb.at(x0, y0 + y);
        for (size_t i = 0; i < top.size(); ++i) row[i] = top[i] + static_cast<float>(y) * slope[i];
    }
}

/// A block's values on their way from coarse to fine.
class BlockGrid {
public:
    BlockGrid(const BlockCorners& corners, const Image& rgb, int x0, int y0)
        : m_corners(corners), m_rgb(rgb), m_x0(x0), m_y0(y0) {}

    void refine() {
        take_corners(kBlock, kBlock + 1);
        for (int step = kBlock; step > 1; step /= 2) {
            const int half = step / 2;
            for (int y = 0; y <= kBlock; y += step)
                for (int x = half; x < kBlock; x += step) set_mean(x, y, x - half, y, x + half, y);
            take_corners(half, step);
            for (int y = half; y < kBlock; y += step)
                for (int x = 0; x <= kBlock; x += half) set_mean(x, y, x, y - half, x, y + half);
            take_corners(half, kBlock + 1);
        }
    }

    void store(Image& rgb) const {
        for (int y = 0; y < kBlock; ++y)
            for (uint32_t bits = BlockCorners::kOwn & ~m_corners.rows[static_cast<size_t>(y)]; bits != 0; bits &= bits - 1) {
                const int x = std::countr_zero(bits);
                std::copy_n(m_value[y][x], 3, rgb.at(m_x0 + x, m_y0 + y));
            }
    }

private:
    void set_mean(int x, int y, int x1, int y1, int x2, int y2) {
        for (int k = 0; k < 4; ++k) m_value[y][x][k] = 0.5f * (m_value[y1][x1][k] + m_value[y2][x2][k]);
    }

    /// Shaded values at grid points `every` pixels apart, in rows that are multiples of `rows`, or of `every` if that is more than
    /// a block.
    void take_corners(int every, int rows) {
        uint32_t columns = 0;
        for (int x = 0; x <= kBlock && m_x0 + x < m_rgb.width; x += every) columns |= 1u << x;
        for (int y = 0; y <= kBlock && m_y0 + y<m_rgb.height; y += rows> kBlock ? every : rows)
            for (uint32_t bits = m_corners.rows[static_cast<size_t>(y)] & columns; bits != 0; bits &= bits - 1) {
                const int x = std::countr_zero(bits);
                std::copy_n(m_rgb.at(m_x0 + x, m_y0 + y), 3, m_value[y][x]);
            }
    }

    const BlockCorners& m_corners;
    const Image& m_rgb;
    int m_x0, m_y0;
    float m_value[kBlock + 1][kBlock + 1][4] = {};
};

}  // namespace

void upsample(const ShadingPlan& plan, Image& rgb) {
    for_each_index(plan.block_rows(), [&](int row) {
        for (int column = 0; column < plan.block_columns(); ++column) {
            const BlockCorners corners(plan, column, row);
            if (plan.is_empty(column, row) || corners.is_shaded()) continue;
            const int x0 = column * kBlock, y0 = row * kBlock;
            if (corners.is_one_cell()) {
                fill_block(x0, y0, rgb);
                continue;
            }
            BlockGrid grid(corners, rgb, x0, y0);
            grid.refine();
            grid.store(rgb);
        }
    });
}

}  // namespace burnish
