// How normals turn between neighbouring pixels, a row at a time with the widest vectors the processor has.
#pragma once

#include <cstddef>
#include <vector>

namespace burnish {

/// One row of a frame in planes. `key` is the pixel's rule, or NaN where it is not valid, so that it equals nothing.
struct TurningRow {
    static constexpr size_t kPadding = 32;  // so that whole vectors, and one more pixel, may be read beyond the end

    explicit TurningRow(size_t width) : x(width + kPadding), y(width + kPadding), z(width + kPadding), key(width + kPadding) {}
    std::vector<float> x, y, z, key;
};

/// Takes `width` interleaved normals; keys are left as they are.
void read_normals(const float* xyz, size_t width, TurningRow& row);

/// squares[i]: the square of the angle between the normals of pixel i of `a` and pixel i + shift of `b`, infinite where keys
/// differ. `width` may be rounded up to whole vectors.
void compare_rows(const TurningRow& a, const TurningRow& b, size_t shift, size_t width, float* squares);

/// Of the squares between four pixels, whose sides are above[i], below[i], left[i] and left[i + 1], each largest one; then of two
/// neighbouring such squares: largest[i] = max(largest[i], squares 2 i and 2 i + 1).
void add_largest_sides(const float* above, const float* below, const float* left, size_t width, float* largest);

}  // namespace burnish
