// A spherical Gaussian of directions as a few rays: where its mass is cut into equal parts, each with the width of a part.
#pragma once

#include <burnish/base/types.h>

#include <span>
#include <vector>

namespace burnish {

class RayBundle {
public:
    /// 1 or more rays; with their parts they spread as much as the Gaussian.
    explicit RayBundle(int rays);

    /// Places about the axis, in widths of the Gaussian.
    std::span<const Vec2f> places() const { return m_places; }
    /// Width of a part, in widths of the Gaussian.
    float part() const { return m_part; }
    /// Mean of g^2 / (g^2 + k^2) over the part of ray i, g = exp(-r^2 / 2) at r widths from the axis.
    float mean_share(size_t i, float k) const;

private:
    std::vector<Vec2f> m_places;
    float m_part;
};

/// A cone of directions about a ray that leaves a surface: exp((cos - 1) / sigma^2), with what lies below the surface's horizon
/// mirrored up, since nothing is seen there.
class Cone {
public:
    /// `d` and `up` are unit vectors, d . up >= 0; sigma > 0, radian.
    Cone(const Vec3f& d, const Vec3f& up, float sigma);

    /// The direction `place` widths off the axis.
    Vec3f direction(const Vec2f& place) const;
    /// The direction's square distance from the axis in widths, the short way and by way of the horizon.
    Vec2f squares(const Vec3f& d) const;
    /// Density at such distances, per steradian; the whole has mass 1.
    float density(const Vec2f& squares) const;
    float sigma() const { return m_sigma; }

private:
    Frame m_frame;
    Vec3f m_up;
    float m_sigma, m_peak;
};

}  // namespace burnish
