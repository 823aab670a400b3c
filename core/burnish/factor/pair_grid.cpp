#include <burnish/factor/pair_grid.h>

#include <burnish/base/error.h>

namespace burnish {

PairGrid::PairGrid(const Parametrization& parametrization, int size) : m_layout(Mapping::parabolic, size) {
    if (!parametrization.pair_of)
        throw Error(ErrorCode::bad_argument,
                    "parametrisation " + parametrization.name + " is not one of BRDFs; expected io, hd or pqp");
    for (int texel = 0; texel < m_layout.texels(); ++texel) {
        if (!m_layout.holds(texel)) continue;
        m_texels.push_back(texel);
        m_directions.push_back(m_layout.direction(texel));
    }
}

}  // namespace burnish
