// The factorisation of logarithms: a linear problem, solved from coarse maps and few samples to fine ones (Factor 3.1.2).
#pragma once

#include <burnish/factor/factor_level.h>

namespace burnish {

/// The unknowns of a level with one term.
Colors log_solution(const FactorLevel& level, const FactoriseSettings& settings);

}  // namespace burnish
