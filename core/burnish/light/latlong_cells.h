// A lat-long picture as cells of constant radiance, bounded by meridians and by the heights s = sin(latitude) of its rows: in
// (longitude, s) solid angle is plain area, so that the picture can be integrated exactly, piece by piece.
#pragma once

#include <burnish/base/image.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace burnish {

/// Radiance times solid angle, and the solid angle, of what has been covered so far.
struct Coverage {
    double energy[3] = {0, 0, 0}, solid_angle = 0;

    /// Mean radiance of what has been covered.
    void store(float* rgb) const {
        for (int k = 0; k < 3; ++k) rgb[k] = solid_angle > 0.0 ? static_cast<float>(energy[k] / solid_angle) : 0.0f;
    }
};

class LatLongCells {
public:
    explicit LatLongCells(const Image& picture)
        : m_picture(picture), m_heights(picture.height + 1), m_sun_columns(picture.width), m_sun_rows(picture.height) {
        for (int row = 0; row <= picture.height; ++row) m_heights[row] = std::cos(std::numbers::pi * row / picture.height);
        find_suns();
    }

    /// Whether a sun may stand between u0 and u1 (edge-to-edge coordinate, may leave [0, 1]), at any height.
    bool may_have_sun(double u0, double u1) const {
        const int columns = m_picture.width;
        for (double cell = std::floor(u0 * columns); cell < u1 * columns; cell += 1.0) {
            if (m_sun_columns[wrapped(cell)]) return true;
        }
        return false;
    }
    /// The same between two heights as well.
    bool may_have_sun(double u0, double u1, double upper, double lower) const {
        if (!may_have_sun(u0, u1)) return false;
        const auto first = m_sun_rows.begin() + row_at(upper), last = m_sun_rows.begin() + row_at(lower) + 1;
        return std::find(first, last, true) != last;
    }

    /// Calls visit(column, longitude, width) for steps from u0 to u1 (edge-to-edge coordinate, may leave [0, 1]); no step
    /// crosses a meridian between two columns, and a column takes at least `least` of them.
    /// `longitude` = 2 pi u at the step's middle, `width` in radians.
    template <class Visit>
    void for_each_step(double u0, double u1, int least, Visit&& visit) const {
        const int columns = m_picture.width;
        const double first = u0 * columns, last = u1 * columns;
        for (double cell = std::floor(first); cell < last; cell += 1.0) {
            const double from = std::max(first, cell), to = std::min(last, cell + 1.0);
            const double width = (to - from) / columns * kTwoPi;
            if (!(width > 0.0)) continue;
            const int steps = std::max(least, static_cast<int>(std::ceil(width / kLargestStep)));
            for (int i = 0; i < steps; ++i) {
                visit(wrapped(cell), kTwoPi * (from + (to - from) * (i + 0.5) / steps) / columns, width / steps);
            }
        }
    }

    /// The row that holds height s.
    int row_at(double s) const {
        const int row = static_cast<int>(std::acos(s) / std::numbers::pi * m_picture.height);
        return std::clamp(row, 0, m_picture.height - 1);
    }

    /// Adds the part of a column between heights `upper` and `lower`, `width` wide. `row` is a guess at the row of `upper`,
    /// and is left where `lower` lies.
    void add(int column, int& row, double upper, double lower, double width, Coverage& sum) const;

private:
    static constexpr double kTwoPi = 2.0 * std::numbers::pi;
    static constexpr double kLargestStep = 1.0 / 32.0;  // radians of longitude between two quadrature points, at most
    static constexpr double kSunShare = 1e-4;           // of the whole picture's energy makes a texel a sun

    int wrapped(double cell) const { return ((static_cast<int>(cell) % m_picture.width) + m_picture.width) % m_picture.width; }

    /// Marks the rows and columns of texels that hold kSunShare of the picture's energy.
    void find_suns();

    const Image& m_picture;
    std::vector<double> m_heights;
    std::vector<char> m_sun_columns, m_sun_rows;
};

}  // namespace burnish
