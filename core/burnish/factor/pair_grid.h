// The regular grid that BRDFs are sampled on: every direction of a disc's texels with every other one.
#pragma once

#include <burnish/factor/factors.h>

#include <vector>

namespace burnish {

class PairGrid {
public:
    /// Throws Error(bad_argument) for a parametrisation of lighting, and for sizes out of range.
    PairGrid(const Parametrization& parametrization, int size);

    const DirectionMap& layout() const { return m_layout; }
    /// The texels of the disc that hold directions, and those.
    const std::vector<int>& texels() const { return m_texels; }
    const std::vector<Vec3f>& directions() const { return m_directions; }

private:
    DirectionMap m_layout;
    std::vector<int> m_texels;
    std::vector<Vec3f> m_directions;
};

}  // namespace burnish
