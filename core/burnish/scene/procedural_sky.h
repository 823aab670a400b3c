// A sky by formula, for demos and tests: blue gradient, haze, hills, a small sun of high contrast, soft boxes of a studio, and
// a ground whose radiance is the light it would really send back, darker straight below, where objects shade it.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <vector>

namespace burnish {

/// A soft rectangular light at infinity, given on the plane at distance 1 along `centre`.
struct SoftBox {
    Vec3f centre;  // direction of its middle, unit
    Vec2f half;    // half width (level) and half height, tangents of the angles
    Color3f radiance;
};

class ProceduralSky {
public:
    ProceduralSky();

    /// Radiance from unit direction d, world space, Z up. The sun is ProceduralSky::sun_direction.
    Color3f radiance(const Vec3f& d) const;

    /// Irradiance of level, open ground (from everything above the horizon), and the ground's albedo.
    Color3f ground_irradiance() const { return m_ground_irradiance; }
    static Color3f ground_albedo() { return {0.22f, 0.20f, 0.178f}; }
    static Vec3f sun_direction();

    /// Lat-long picture, RGB, Blender's layout (+X in the middle, Z up), height = width / 2; texels average `samples`^2 points.
    Image picture(int width, int samples) const;

private:
    Color3f without_sun(const Vec3f& d) const;

    std::vector<SoftBox> m_boxes;
    Color3f m_ground_irradiance{0.0f};
};

/// Direction of raster position (x, y) in a lat-long picture of Blender's layout.
Vec3f latlong_direction(float x, float y, int width, int height);

}  // namespace burnish
