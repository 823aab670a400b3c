// Two ways to blur one level of a cube map into another by spherical Gaussians; both see directions, not faces, so there are
// no seams, and give every texel weights that sum to one.
#pragma once

#include <burnish/light/filter/cube_level.h>
#include <burnish/light/filter/gaussian_width.h>

namespace burnish {

/// By thirteen bilinear lookups a texel, for kernels about as wide as what the source was blurred by already.
void blur_by_taps(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target);

/// By a sum over all texels under the kernel, with their solid angles: for any source. Its lookups count as texel values.
void blur_by_sum(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target);

}  // namespace burnish
