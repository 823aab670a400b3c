// A measurement on a grid of half and difference angles: where errors are summed and where microfacet models are fitted.
//
// Highlights of any view lie at small theta_h, so a grid that is fine there resolves every peak, whatever the direction it is seen
// from. With theta_h = t^2 90 deg, 90 rows, its nodes are the middles of MERL's cells. For isotropic f
//
//     integral g dwo dwi = integral g 2 pi sin(theta_h) dtheta_h  4 cos(theta_d) sin(theta_d) dtheta_d dphi_d
//
// Only what measurements are trusted for counts: theta_d below 70 degrees (Bandwidth V.3.4: sensors see the lamp beyond), both
// directions below 80 degrees from the normal.
#pragma once

#include <burnish/base/types.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace burnish {

class MeasuredBrdf;

inline constexpr double kTrustedDifference = 70 * std::numbers::pi / 180;
inline constexpr double kTrustedElevation = 80 * std::numbers::pi / 180;

/// One number for each of red, green and blue.
using Channels = std::array<double, 3>;

/// How many middles of equal cells: theta_h in t of theta_h = t^power 90 deg, theta_d over 90 deg, phi_d over 180 deg, which is
/// enough for reciprocal f. Odd divisors of MERL's 90, 90, 180 meet the middles of its cells.
struct GridSize {
    int theta_h = 90, theta_d = 30, phi_d = 36;
    int power = 2;
};

/// Half and difference angles in radians; phi_h = 0.
struct GridAngles {
    double theta_h, theta_d, phi_d;
};

class BrdfGrid {
public:
    /// A pair of directions that is trusted and was measured.
    struct Cell {
        int h, d, p;
        double cos_i, cos_o;
        double weight;  // its share of the integral over wo and wi, times cos_i cos_o
    };
    /// f in 1/sr; nothing where it was not measured.
    using Values = std::function<std::optional<Channels>(const GridAngles&)>;

    BrdfGrid(const GridSize& size, const Values& values);
    /// The cells of a MERL table as they are, other measurements by their `eval` (in float: peaks narrower than 1e-4 are blurred).
    BrdfGrid(const GridSize& size, const MeasuredBrdf& measured);

    const std::vector<Cell>& cells() const { return m_cells; }
    const std::vector<double>& theta_h() const { return m_theta_h; }
    GridAngles angles(const Cell& cell) const { return {m_theta_h[cell.h], theta_d(cell.d), phi_d(cell.p)}; }
    double theta_d(int d) const { return (d + 0.5) * std::numbers::pi / (2 * m_size.theta_d); }
    double phi_d(int p) const { return (p + 0.5) * std::numbers::pi / m_size.phi_d; }

    /// The cells that `wanted` picks; their weights stay as they are.
    BrdfGrid subset(const std::function<bool(const Cell&)>& wanted) const;

    /// f of all cells, in their order.
    const std::vector<double>& f(int channel) const { return m_f[channel]; }
    /// The greatest directional albedo of a channel, over rings of 5 degrees; what is not trusted counts as black.
    double max_albedo(int channel) const;

private:
    void add_row(int h, int d, double row_weight, const Values& values);

    GridSize m_size;
    std::vector<double> m_theta_h;
    std::vector<Cell> m_cells;
    std::array<std::vector<double>, 3> m_f;
};

}  // namespace burnish
