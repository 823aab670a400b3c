// A picture over texture coordinates and its halved copies, for lookups as wide as a disc.
//
// A texel that was halved n times, read bilinearly, has the spread of a disc 2^(n + 1) texels across: so much of a disc's width
// is left to the copies, and one of less than two texels is as sharp as the picture.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <vector>

namespace burnish {

class MapPyramid {
public:
    MapPyramid() = default;
    /// From an RGB picture; an empty one gives an empty pyramid.
    MapPyramid(Image picture, int halvings);

    bool empty() const { return m_levels.empty(); }
    /// Texels per unit of texture coordinates, as their geometric mean; 0 when empty.
    float resolution() const;
    /// The mean over a disc `texels` wide about (u, v); u right, v up, clamped at the edges. Any place and width is safe.
    Color3f at(const Vec2f& uv, float texels) const;
    /// The widest disc that `at` averages, texels.
    float widest() const;

private:
    Color3f bilinear(size_t level, const Vec2f& place) const;

    std::vector<Image> m_levels;
};

}  // namespace burnish
