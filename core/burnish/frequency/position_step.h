// Where a surface ends before another one that faces the same way: a table's edge over the floor, the same material on both.
//
// Along a surface the way dP from one pixel to the next lies across the normal, mean of both pixels'; on a curve of constant
// curvature exactly. At a step it has a part along the view. What is compared is how far Pb lies off the surface, along the view,
//
//     |n . dP| / |n . w|    with    |dP| / 2,    w = unit vector to the eye,
//
// which has no scale of its own, holds at grazing angles, and lets pass what positions in half float are wrong by.
#pragma once

#include <burnish/input/frame.h>

namespace burnish {

class PositionStep {
public:
    /// Sees no steps.
    PositionStep() = default;
    /// By geometric normals where the frame has them.
    explicit PositionStep(const AovFrame& frame);

    /// squares[i] = infinity where there is a step from pixel (first + i, y), i in [0, count), to the one (dx, dy) further, of those
    /// in the frame.
    void add(int y, int first, int count, int dx, int dy, float* squares) const;

private:
    const Image *m_position = nullptr, *m_normal = nullptr;
    Vec3f m_eye{0, 0, 0};
};

}  // namespace burnish
