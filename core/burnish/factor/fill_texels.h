// Texels that nothing is known of, from those beside them.
#pragma once

#include <burnish/factor/sample_lookups.h>

namespace burnish {

/// Ring by ring: the mean of the neighbours that are `known` or filled before. `texels`: one map's.
void fill_texels(const DirectionMap& layout, Eigen::Ref<Colors> texels, std::vector<char> known);

}  // namespace burnish
