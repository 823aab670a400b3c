// From one level of a cube map to the next coarser one: binomial kernels that run across the faces' edges and keep both a
// constant radiance and the total energy.
//
// A coarse texel c takes from the fine texels i
//
//     L_c = (1 / Omega_c) sum_i P_ci L_i,     P_ci = a_c k_ci b_i,     sum_i P_ci = Omega_c,     sum_c P_ci = Omega_i,
//
// k the plain separable kernel on the unfolded cube, Omega the texels' solid angles. The first sum makes a constant stay
// constant, the second keeps sum L Omega. The factors a and b come from Sinkhorn's iteration (Sinkhorn 1964), they depend
// on the size and the kernel only and are the same for the six faces. Constants are kept to rounding, the energy of any
// picture to rounding by the 2 x 2 box and to 5e-4 over the whole pyramid by the others.
#pragma once

#include <burnish/light/filter/cube_pyramid.h>

#include <vector>

namespace burnish {

/// A double per texel of a face's upper left quarter, size x size of them: all fields here have the symmetry of the square.
struct FaceField {
    int size = 0;
    std::vector<double> values;
};

class CubeFilter {
public:
    /// For a pyramid whose finest faces have `size` texels a side.
    CubeFilter(int size, PyramidKernel kernel);

    /// Sets all texels of `coarse`, of half the size, borders too. Levels must come in order, from the finest on.
    void coarser(const CubeLevel& fine, CubeLevel& coarse);

private:
    /// A start for a from which the iteration has little left to do.
    FaceField expected_factor() const;
    void balance();

    std::vector<double> m_taps;          // one row of the separable kernel, sums to 1
    std::array<double, 4> m_drift;       // of expected_factor
    FaceField m_fine, m_coarse;          // solid angles of the level to be filtered and of the one to be made
    std::vector<float> m_fine_weight;    // b_i
    std::vector<float> m_coarse_weight;  // a_c / Omega_c
};

}  // namespace burnish
