#include <burnish/light/filter/light_curvature.h>

#include <burnish/base/parallel.h>

namespace burnish {
namespace {

/// Four lines through a texel: along the row, the column and both diagonals. Lines on a face are great circles.
struct Line {
    int dx, dy;
};
constexpr Line kLines[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};

/// Arc per step of a line at (u, v) of the face [-1, 1]^2, steps being h long.
float arc_of_step(const Line& line, float h, float u, float v) {
    const float du = h * static_cast<float>(line.dx), dv = h * static_cast<float>(line.dy);
    const float cross = u * dv - v * du;
    return std::sqrt(du * du + dv * dv + cross * cross) / (1 + u * u + v * v);
}

/// Weights of f(before) - f(here) and f(after) - f(here) in the second derivative by arc length.
struct SecondDifference {
    float before, after;

    SecondDifference(const Line& line, float h, float u, float v) {
        const float half_u = 0.5f * h * static_cast<float>(line.dx), half_v = 0.5f * h * static_cast<float>(line.dy);
        const float back = arc_of_step(line, h, u - half_u, v - half_v), ahead = arc_of_step(line, h, u + half_u, v + half_v);
        before = 2 / (back * (back + ahead)), after = 2 / (ahead * (back + ahead));
    }
};

/// All channels count alike here: a display shows errors of each.
float brightness(const float* rgba) { return (rgba[0] + rgba[1] + rgba[2]) / 3; }

/// The largest second derivative at each texel; borders are yet to be filled. Lines bend where they leave the face, so its outermost
/// texels have none of their own: what is there shows in their neighbours', and comes back by `spread_largest`.
void set_second_derivatives(CubeLevel& level) {
    const int size = level.size();
    const float h = 2.0f / static_cast<float>(size);
    for_each_index(size, [&](int y) {
        const float v = (static_cast<float>(y) + 0.5f) * h - 1;
        for (int x = 0; x < size; ++x) {
            if (x == 0 || y == 0 || x == size - 1 || y == size - 1) {
                for (int face = 0; face < 6; ++face) level.at(face, x, y)[3] = 0;
                continue;
            }
            const float u = (static_cast<float>(x) + 0.5f) * h - 1;
            float largest[6] = {};
            for (const Line& line : kLines) {
                const SecondDifference weight(line, h, u, v);
                for (int face = 0; face < 6; ++face) {
                    const float here = brightness(level.at(face, x, y));
                    const float before = brightness(level.at(face, x - line.dx, y - line.dy)) - here;
                    const float after = brightness(level.at(face, x + line.dx, y + line.dy)) - here;
                    largest[face] = std::max(largest[face], std::fabs(weight.before * before + weight.after * after));
                }
            }
            for (int face = 0; face < 6; ++face) level.at(face, x, y)[3] = largest[face];
        }
    });
}

/// Every texel takes the largest fourth channel of the 3 x 3 about it.
void spread_largest(CubeLevel& level) {
    const int size = level.size(), stride = size + 2;
    for_each_index(6, [&](int face) {
        std::vector<float> rows(static_cast<size_t>(stride) * stride);  // largest of three in a row
        for (int y = -1; y <= size; ++y) {
            float* row = &rows[static_cast<size_t>(y + 1) * stride];
            for (int x = 0; x < size; ++x)
                row[x] = std::max({level.at(face, x - 1, y)[3], level.at(face, x, y)[3], level.at(face, x + 1, y)[3]});
        }
        for (int y = 0; y < size; ++y) {
            const float *above = &rows[static_cast<size_t>(y) * stride], *here = above + stride, *below = here + stride;
            for (int x = 0; x < size; ++x) level.at(face, x, y)[3] = std::max({above[x], here[x], below[x]});
        }
    });
    level.fill_borders();
}

}  // namespace

void set_curvature(float sigma, CubeLevel& level) {
    set_second_derivatives(level);
    level.fill_borders();
    const float texel = 2.0f / static_cast<float>(level.size());
    const int rings = static_cast<int>(std::ceil(kCurvatureReach * sigma / texel));
    for (int ring = 0; ring < rings; ++ring) spread_largest(level);
}

}  // namespace burnish
