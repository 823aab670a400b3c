// The picture of a textured lamp over (u, v) in [0, 1]^2, its lower left corner at (0, 0): filtered with any ellipse for shading,
// exact and drawn from for the reference.
#pragma once

#include <burnish/base/image.h>
#include <burnish/light/filter/planar_stack.h>
#include <burnish/light/sample_table.h>

namespace burnish {

/// A Gaussian on the picture: what its unit circle of deviations becomes, two half axes in (u, v), not of need perpendicular.
struct PictureEllipse {
    Vec2f a, b;
};

class AreaPicture {
public:
    AreaPicture() = default;
    /// RGB, finite, >= 0. aspect: width over height of what it lies on.
    explicit AreaPicture(Image rgb, float aspect = 1);

    bool empty() const { return m_rgb.empty(); }
    const Image& rgb() const { return m_rgb; }
    Color3f mean() const;

    /// Bilinear, clamped at the edges.
    Color3f at(const Vec2f& uv) const;

    struct Filtered {
        Color3f mean{0, 0, 0};  // over the Gaussian's part inside the picture
        float bend = 0;  // bound of the mean of RGB's second derivative, per squared deviation, edges against black included
    };
    /// A Gaussian about a place in the picture: several round lookups along an ellipse's longer axis, up to kLongest times the
    /// shorter one; longer ones are widened.
    Filtered filtered(const Vec2f& uv, const PictureEllipse& ellipse) const;
    static constexpr float kLongest = 4;

    /// A place with density ~ luminance, per unit of (u, v).
    Vec2f sample(const Vec2f& u) const;
    float pdf(const Vec2f& uv) const;

private:
    Image m_rgb;
    PlanarStack m_stack;
    SampleTable m_table;
};

}  // namespace burnish
