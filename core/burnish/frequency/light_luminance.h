// The luminance of distant light on cube faces small enough to be analysed, its discs painted back in.
#pragma once

#include <burnish/light/bright_discs.h>
#include <burnish/light/filter/cube_level.h>

#include <array>
#include <span>

namespace burnish {

/// In red; at most `largest` texels a side, each the mean of the faces' texels in it, borders filled. A disc adds its flux to the
/// texels it covers. Throws Error(bad_argument) unless the faces are square, RGB and of one size, a power of two.
CubeLevel light_luminance(const std::array<Image, 6>& faces, std::span<const BrightDisc> discs, int largest);

/// A face and what is seen around it, all in the face's own plane: (size + 2 border)^2 values of red.
Image surrounded_face(const CubeLevel& level, int face, int border);

}  // namespace burnish
