// The far tail of a lobe as a few wide taps: where lamps stand far off the mirror direction.
//
// A GGX lobe of alpha 0.02 keeps 3 % of its energy beyond six widths. A lamp a hundred times as bright as the room is seen in it
// all the same, and a few Gaussians fitted to the lobe do not reach that far. The tail is cut into rings of half vectors that reach
// three times as far each, the last one to the horizon; a tap stands for a fifth of a ring, at the ring's median, with that ring's
// share of the energy.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/shading/shading_point.h>
#include <burnish/shading/tap.h>

#include <span>
#include <vector>

namespace burnish {

class TailTaps {
public:
    TailTaps() = default;
    /// None for lobes that end like Gaussians, and those as wide as the sky beyond six widths.
    explicit TailTaps(const LobeParameters& lobe);

    int count() const { return static_cast<int>(m_cells.size()); }
    /// Writes count() taps, smooth in the view, Tap::level the logarithm of their widths in radian (lobe_taps.h).
    void at(const ShadingPoint& point, std::span<Tap> taps) const;

private:
    /// A fifth of a ring, in normalised slopes.
    struct Cell {
        float u, v, inner, outer;  // its middle; the ring's radii
        float share;               // of the lobe's energy
    };

    LobeParameters m_lobe;
    std::vector<Cell> m_cells;
};

}  // namespace burnish
