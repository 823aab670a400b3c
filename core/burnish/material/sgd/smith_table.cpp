#include <burnish/material/sgd/smith_table.h>

namespace burnish {

SmithTable::SmithTable(const ShiftedGamma& slopes) : m_mean_slope(static_cast<float>(slopes.mean_slope())) {
    float* nodes = m_nodes.data() + 1;
    for (int i = 0; i < kCells; ++i) nodes[i] = static_cast<float>(slopes.G1(slopes.mean_slope() * i / (kCells - i)));
    nodes[kCells] = nodes[kCells + 1] = 1;
    nodes[-1] = 3 * (nodes[0] - nodes[1]) + nodes[2];  // the parabola through the first three
}

}  // namespace burnish
