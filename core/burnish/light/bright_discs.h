// Suns apart: what is small, and far brighter than all around it, is taken out of the picture as a disc of known flux.
//
// A sun of half a degree holds most of an outdoor picture's light. A few filtered lookups spread it over the solid angle they
// stand for, or miss it; as a disc it is shaded exactly (shading/disc_light.h), and what stays in the picture is easy for every
// estimator. Only the excess over the surround is taken, so that no hole is left, and rest + discs = whole picture.
#pragma once

#include <burnish/base/types.h>
#include <burnish/light/picture_cells.h>

#include <string>
#include <vector>

namespace burnish {

/// Light of constant radiance from a small ellipse of directions; light axes.
struct BrightDisc {
    Vec3f direction;      // unit, to the centre
    Vec3f along, across;  // half axes, the longer one first, in radians, perpendicular to `direction`: of the ellipse with the
                          // light's own second moments, the picture's bilinear interpolation included
    Color3f flux;         // excess radiance integrated over solid angle

    float longest_radius() const { return std::sqrt(along.length2()); }
    /// Of the circle of the same area.
    float radius() const { return std::sqrt(std::sqrt(along.length2() * across.length2())); }
};

/// The discs taken out of a picture, largest flux first, and what is needed to make the picture whole again.
class DiscCut {
public:
    DiscCut() = default;
    /// Finds at most 8 discs and subtracts them from the picture, whose values must be finite and >= 0. A disc is up to 1.8
    /// degrees across, holds at least 1 % of the luminance, and is much brighter than the picture and than its surround.
    explicit DiscCut(const PictureCells& cells);

    /// Gives the picture its values back, bit by bit; the picture must be where it was.
    void put_back();

    const std::vector<BrightDisc>& discs() const { return m_discs; }
    /// One line each: size and share of the light.
    std::vector<std::string> notes() const;

private:
    struct Texel {
        float* rgb;
        Color3f whole;
    };
    std::vector<BrightDisc> m_discs;
    std::vector<Texel> m_texels;  // in the order they were cut
    double m_total_luminance = 0;
};

}  // namespace burnish
