// Between a filtered picture, which is smooth but a little off, and an unfiltered one, which is right but noisy: at each pixel the mean
// whose expected error is the least.
//
// With error b of the filtered picture and standard error s of the other the best share of the other is b^2 / (b^2 + s^2). The two
// differ by d, and the mean of d^2 is b^2 + s^2, so b^2 is what d^2 leaves beyond s^2; one pixel's d says little of it, so it is taken,
// relative to the light there, over the pixels around that wear the same material (Stein's shrinkage, pooled: Efron & Morris 1973).
// As s goes to 0 the result goes to the unfiltered picture, and no picture on the way there is worse than either by more than chance.
#pragma once

#include <burnish/shading/dense.h>

namespace burnish {

/// `reference`: with its standard errors and lookups. Of the result, these are the blend's own and the reference's. Bit-identical for
/// any thread count.
ShadedFrame blend(const ShadedFrame& filtered, const ShadedFrame& reference, const Surfaces& surfaces,
                  const Assignment& assignment);

}  // namespace burnish
