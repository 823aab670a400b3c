// The two-slice fit of one channel, and what goes beyond it: the whole table, starts from everywhere, a second lobe.
//
// Two slices (Bandwidth V.4.2): theta_d = 0 gives kd and the shape, theta_h = 0 then strength and Fresnel; residuals in ratio to f,
// so that the tail counts as the peak does. Then the same shapes against all cells, weighted as the error of V.5.3 weighs them.
// Both steps start from a scan of all shapes, which costs little as the rest is linear, and follow the best few to the bottom. Internal.
#pragma once

#include <burnish/fit/slices/channel_problem.h>
#include <burnish/fit/slices/least_squares.h>

namespace burnish {

/// The parts of a grid that fits look at.
struct FitGrids {
    BrdfGrid all;
    BrdfGrid cells, coarse;     // some 15,000 and 1,500 of them, middles of equal cells again
    BrdfGrid slice_h, slice_d;  // theta_d and theta_h near 0

    explicit FitGrids(const BrdfGrid& grid);
};

/// Ranges of the numbers of one lobe.
struct LobeBounds {
    std::vector<SearchRange> shape;
    LinearBounds linear;
};

class ChannelSearch {
public:
    ChannelSearch(const FitGrids& grids, int channel, const ShapeFamily& family, const LobeBounds& bounds);

    /// By the slices alone.
    ChannelFit two_slices() const;
    /// Against the cells, from `start` and from the best shapes of a scan; whichever ends lowest.
    ChannelFit polished(const ChannelFit& start) const;
    /// Of sgd, the numbers of its fitted G1 free as well, from Smith's of each start; shapes have five numbers then.
    ChannelFit with_free_masking(const ChannelFit& start) const;
    /// One lobe more than `fit` has, all shapes free, masked as the family says.
    ChannelFit with_another_lobe(const ChannelFit& fit) const;
    /// The error of V.5.3, not normalised, on all cells.
    double error(const ChannelFit& fit) const;
    double error(const ShapeFamily& family, const ChannelFit& fit) const;

private:
    using Shapes = std::vector<std::vector<double>>;

    /// The starts followed on few cells, and the best of what they lead to on all.
    ChannelFit best_of(const ShapeFamily& family, std::span<const SearchRange> each, std::span<const Shapes> starts) const;
    ChannelFit descend(const ChannelProblem& problem, const ShapeFamily& family, std::span<const SearchRange> each,
                       const Shapes& start) const;
    std::vector<Shapes> best_starts(const ChannelProblem& problem, const Shapes& fixed) const;

    const ShapeFamily& m_family;
    LobeBounds m_bounds;
    ChannelProblem m_all, m_cells, m_coarse, m_slice_h, m_slice_d;
};

}  // namespace burnish
