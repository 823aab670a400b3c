// A distribution of squared slopes as a table: what is drawn from it is exactly what its density says.
//
// Nodes lie evenly in ln(c + x), so that cells resolve peaks at x ~ c and tails alike; in a cell the density is constant and the
// share beyond falls linearly.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

namespace burnish {

class SlopeTable {
public:
    /// Of the density P(x), x in [0, end]; `c`: squared slope at which its peak ends.
    SlopeTable(const std::function<double(double x)>& density, double c, double end);

    /// Density of x as drawn, 0 beyond the end.
    float density(float x) const;
    /// The squared slope beyond which the share xi in (0, 1] lies; 0 at 1.
    float beyond(double xi) const;

private:
    static constexpr int kCells = 256;

    float m_c, m_log_c, m_inv_step;
    std::array<float, kCells + 1> m_x;
    std::array<double, kCells + 1> m_share;  // m_share[i] of the slopes beyond m_x[i], falling from 1 to 0
    std::array<float, kCells> m_density;
};

}  // namespace burnish
