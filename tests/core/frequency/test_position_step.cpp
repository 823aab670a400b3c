// Steps between surfaces that face the same way, seen from anywhere, at any scale, in float and in half; and none elsewhere.
#include "core/level_views.h"

#include <burnish/frequency/cell_turning.h>
#include <burnish/frequency/position_step.h>

#include <Imath/half.h>
#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish::scenes;

namespace {

void round_to_half(Image& image) {
    for (float& v : image.data) v = Imath::half(v);
}

/// Pairs of neighbours, right and below, both there: steps found; `expected` says of two places whether there is one.
struct Count {
    size_t pairs = 0, steps = 0, wrong = 0;
};
template <class Expected>
Count count_steps(const AovFrame& frame, const Expected& expected) {
    const PositionStep steps(frame);
    const Image& position = frame.layer(Role::position);
    const Image& normal = frame.layer(Role::normal);
    Count count;
    for (const int down : {0, 1})
        for (int y = 0; y < position.height - down; ++y) {
            std::vector<float> squares(static_cast<size_t>(position.width), 0.0f);
            steps.add(y, 0, position.width, 1 - down, down, squares.data());
            for (int x = 0; x + 1 - down < position.width; ++x) {
                const float *a = position.at(x, y), *b = position.at(x + 1 - down, y + down);
                const float *na = normal.at(x, y), *nb = normal.at(x + 1 - down, y + down);
                if (Vec3f(na[0], na[1], na[2]).length2() == 0 || Vec3f(nb[0], nb[1], nb[2]).length2() == 0) continue;
                const bool found = std::isinf(squares[static_cast<size_t>(x)]);
                ++count.pairs, count.steps += found, count.wrong += found != expected(a, b);
            }
        }
    return count;
}

const auto kNever = [](const float*, const float*) { return false; };

TEST(PositionStep, FindsTheEdgesOfATableAndNothingElse) {
    for (const float elevation : {10.0f, 20.0f, 50.0f, 85.0f})
        for (const float scale : {1e-3f, 1.0f, 1e4f}) {
            const AovFrame frame = view_of(table, elevation, scale);
            const auto is_edge = [&](const float* a, const float* b) { return std::fabs(a[2] - b[2]) > 0.25f * scale; };
            const Count count = count_steps(frame, is_edge);
            EXPECT_GT(count.steps, 60u) << elevation;
            EXPECT_EQ(count.wrong, 0u) << elevation << " " << scale;
        }
}

TEST(PositionStep, CurvesAndGrazingPlanesHaveNone) {
    for (const float elevation : {1.0f, 5.0f, 40.0f, 90.0f})
        EXPECT_EQ(count_steps(view_of(floor_only, elevation), kNever).wrong, 0u);
    for (const int size : {20, 160, 700}) {
        const Count count = count_steps(view_of(ball, 30, 1, Vec3f(0), size), kNever);
        EXPECT_EQ(count.wrong, 0u) << size << " of " << count.pairs;
    }
}

TEST(PositionStep, LetsPassWhatHalvesAreWrongBy) {
    for (const Vec3f& offset : {Vec3f(0), Vec3f(3, -20, 7), Vec3f(500, 100, 0)}) {
        for (const auto& [scene, elevation] : {std::pair<Seen, float>(floor_only, 3.0f), {ball, 30.0f}}) {
            AovFrame frame = view_of(scene, elevation, 1, offset, 700);
            round_to_half(frame.layers[Role::position]);
            const Count count = count_steps(frame, kNever);
            EXPECT_LT(static_cast<double>(count.wrong), 1e-4 * static_cast<double>(count.pairs)) << offset.x;
        }
    }
    AovFrame frame = view_of(table, 30);
    round_to_half(frame.layers[Role::position]);
    EXPECT_EQ(count_steps(frame, [](const float* a, const float* b) { return std::fabs(a[2] - b[2]) > 0.25f; }).wrong, 0u);
}

TEST(PositionStep, CellsEndThereWhereLightsAreNear) {
    const AovFrame frame = view_of(table, 50);
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    const CellTurning plain(frame, surfaces, assignment, {}), ending(frame, surfaces, assignment, {}, AtSteps::end);
    const Image& position = frame.layer(Role::position);
    int ends = 0;
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column) {
            float low = 1, high = 0;
            for (int y = 16 * row; y <= 16 * row + 16; ++y)
                for (int x = 16 * column; x <= 16 * column + 16; ++x)
                    low = std::min(low, position.at(x, y)[2]), high = std::max(high, position.at(x, y)[2]);
            const bool is_crossed = high - low > 0.25f;
            EXPECT_TRUE(std::isfinite(plain.at(3, column, row)));
            EXPECT_EQ(std::isinf(ending.at(3, column, row)), is_crossed) << column << " " << row;
            ends += is_crossed;
        }
    EXPECT_GT(ends, 4);
}

}  // namespace
