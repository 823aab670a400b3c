#include "core/scenes.h"
#include "core/simd_targets.h"

#include <burnish/base/parallel.h>
#include <burnish/frequency/cell_turning.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

/// The turning of every cell by its definition, the brute way: all four sides of every square of four pixels in the cell.
float brute_turning(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment, int size, int column,
                    int row) {
    const Image& normal = frame.layer(Role::normal);
    const auto turning = [&](int ax, int ay, int bx, int by) {
        if (bx >= normal.width || by >= normal.height) return std::numeric_limits<float>::infinity();
        const size_t a = static_cast<size_t>(ay) * normal.width + ax, b = static_cast<size_t>(by) * normal.width + bx;
        const bool same = surfaces.validity(a) == Validity::valid && surfaces.validity(b) == Validity::valid &&
                          assignment.rule[a] == assignment.rule[b];
        if (!same) return std::numeric_limits<float>::infinity();
        const Vec3f na(normal.at(a)[0], normal.at(a)[1], normal.at(a)[2]),
            nb(normal.at(b)[0], normal.at(b)[1], normal.at(b)[2]);
        return (nb - na).length() / na.length();
    };
    float largest = 0;
    for (int y = row * size; y < (row + 1) * size; ++y)
        for (int x = column * size; x < (column + 1) * size; ++x)
            for (const float side : {turning(x, y, x + 1, y), turning(x, y, x, y + 1), turning(x + 1, y, x + 1, y + 1),
                                     turning(x, y + 1, x + 1, y + 1)})
                largest = std::max(largest, x >= normal.width || y >= normal.height ? INFINITY : side);
    return largest;
}

void expect_brute(const AovFrame& frame, const Assignment& assignment) {
    const Surfaces surfaces(frame, assignment, {});
    const CellTurning turning(frame, surfaces, assignment, {});
    for (int level = 0; level < CellTurning::kLevels; ++level)
        for (int row = 0; row < turning.rows(level); ++row)
            for (int column = 0; column < turning.columns(level); ++column) {
                const int size = CellTurning::cell_size(level), per_block = CellTurning::kLargest / size;
                if (turning.is_empty(column / per_block, row / per_block)) continue;
                const float expected = brute_turning(frame, surfaces, assignment, size, column, row);
                const float found = turning.at(level, column, row);
                if (std::isinf(expected))
                    ASSERT_TRUE(std::isinf(found)) << size << " " << column << " " << row;
                else
                    ASSERT_NEAR(found, expected, 1e-6f + 1e-3f * expected) << size << " " << column << " " << row;
            }
}

TEST(CellTurning, IsTheFastestTurningOfAnySideInTheCell) {
    burnish_test::for_each_target([] {
        const AovFrame frame = scenes::sphere_frame(75);
        expect_brute(frame, scenes::whole_frame(frame));
    });
}

TEST(CellTurning, CellsEndWhereMaterialsDo) {
    const AovFrame frame = scenes::covered_frame(61, 47);
    Assignment assignment = scenes::whole_frame(frame);
    std::mt19937 random(1);
    for (int i = 0; i < 12; ++i) assignment.rule[random() % assignment.rule.size()] = 1;
    for (size_t i = 0; i < assignment.rule.size(); ++i)
        if (i % 61 > 40) assignment.rule[i] = 2;
    assignment.counts = {1, 1, 1};
    expect_brute(frame, assignment);
}

TEST(CellTurning, EmptyBlocksAreThoseWithoutAValidPixel) {
    const AovFrame frame = scenes::sphere_in_frame(160, 96, 20);
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const CellTurning turning(frame, surfaces, assignment, {});
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 10; ++column) {
            bool any = false;
            for (int y = 16 * row; y < 16 * row + 16; ++y)
                for (int x = 16 * column; x < 16 * column + 16; ++x)
                    any |= surfaces.validity(static_cast<size_t>(y) * 160 + x) == Validity::valid;
            EXPECT_EQ(turning.is_empty(column, row), !any);
        }
}

/// A layer that some lobe reads: a step ends cells, a gradient does not, and roughness counts as turning.
TEST(CellTurning, LayersCountWhereLobesReadThem) {
    AovFrame frame = scenes::covered_frame(64, 64);
    for (const Role role : {Role::roughness, Role::weight}) frame.layers[role] = Image(64, 64, 1, 0.5f);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            *frame.layers[Role::weight].at(x, y) = x < 30 ? 0.5f : 1.0f + 0.001f * x;
            *frame.layers[Role::roughness].at(x, y) = y == 40 ? 0.7f : 0.5f;
        }
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const CellTurning plain(frame, surfaces, assignment, {});
    const CellTurning used(frame, surfaces, assignment, {.roughness = true, .weight = true});
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 7; ++column) {
            const bool steps = column == 3, rough = row == 4 || row == 5;
            const float alpha = row == 4 ? 0.25f : 0.49f, bend = row == 4 ? 0.24f : 0.48f;  // where alpha bends most
            EXPECT_TRUE(std::isfinite(plain.at(2, column, row)));
            EXPECT_EQ(std::isinf(used.at(2, column, row)), steps);
            if (steps) continue;
            if (rough)
                EXPECT_NEAR(used.at(2, column, row), std::sqrt(0.5f * alpha * bend), 1e-4f);
            else
                EXPECT_EQ(used.at(2, column, row), plain.at(2, column, row));
        }
}

}  // namespace
