// Where a factorisation starts: each map the average of the samples that read it, shared out among the factors (Factor 3.1.2). With one
// factor that is nearly all there is to do.
#pragma once

#include <burnish/factor/sample_lookups.h>

namespace burnish {

/// For `values` (a sample a row, logarithms) whose factors add up to them. Texels that no sample reads take the mean of their neighbours.
Colors averaged_start(const Factors& layout, const SampleLookups& lookups, const Colors& values);

}  // namespace burnish
