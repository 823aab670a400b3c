// Smith's G1 of a shifted gamma distribution, tabulated: the double integral has no closed form.
//
// Nodes lie evenly in t = cot / (cot + mean slope), which maps all directions to [0, 1] and in which G1 rises gently from 0 to 1 at
// every width; cubic in between.
#pragma once

#include <burnish/material/sgd/shifted_gamma.h>

#include <array>
#include <cstddef>

namespace burnish {

class SmithTable {
public:
    explicit SmithTable(const ShiftedGamma& slopes);

    /// G1 at cot theta >= 0, to 1e-6.
    float G1(float cot_theta) const {
        const float at = cot_theta / (cot_theta + m_mean_slope) * kCells;
        if (!(at < kCells)) return 1;  // straight above, cot = inf included
        const int cell = static_cast<int>(at);
        const float f = at - static_cast<float>(cell);
        const float* g = &m_nodes[static_cast<std::size_t>(cell)];  // of t one cell before this one
        const float a = 0.5f * (g[2] - g[0]), b = 0.5f * (g[3] - g[1]), rise = g[2] - g[1];
        return g[1] + f * (a + f * (3 * rise - 2 * a - b + f * (a + b - 2 * rise)));
    }

private:
    static constexpr int kCells = 128;

    float m_mean_slope;
    std::array<float, kCells + 3> m_nodes;  // one more at either end
};

}  // namespace burnish
