// A flat picture of light filtered with Gaussians of every width: what mirror buffers and textured lamps are read from.
//
// Outside its edges, and where it has holes, the picture answers for nothing: radiance is premultiplied with cover, so a lookup
// that hangs over an edge fades to what lies behind. Level 0 is the picture. Widths double up to two texels, then grow by sqrt(2);
// texels are at most 3/4 of a width. A level's width is that of its lookups: what is in the texels and the tent of the bilinear
// reading together. Levels reach beyond the picture as far as their Gaussians do.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <vector>

namespace burnish {

class PlanarStack {
public:
    PlanarStack() = default;
    /// From RGBA, premultiplied; A is cover in [0, 1]. Throws Error(bad_argument) for other channel counts and empty pictures.
    explicit PlanarStack(const Image& rgba);

    /// Of a lookup, averaged with a Gaussian.
    struct Value {
        Color3f radiance{0, 0, 0};
        float cover = 0;
        float bend = 0;  // bound of the second derivative of the mean of RGB, per square texel of the picture, within
                         // kPlanarReach widths of the place
    };
    static constexpr float kPlanarReach = 2.5f;

    /// At `place` in texels of the picture (its upper left corner is 0, texel centres at + 0.5), `sigma` texels wide. Any place and
    /// width is safe, NaN included.
    Value lookup(const Vec2f& place, float sigma) const;

    bool empty() const { return m_levels.empty(); }
    int width() const { return m_width; }
    int height() const { return m_height; }

    struct Level {
        Image rgba, bend;  // texels; bend has 1 channel
        float sigma = 0;   // of lookups, texels of the picture
        int scale = 1;     // texels of the picture that one is wide
        int margin = 0;    // texels of its own before the picture begins
    };

private:
    std::vector<Level> m_levels;
    int m_width = 0, m_height = 0;
};

}  // namespace burnish
