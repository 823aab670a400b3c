// Linearly transformed cosines (Heitz, Dupuy, Hill & Neubelt 2016), as a rival for isotropic lobes under solid lamps.
//
// A matrix per view angle turns a clamped cosine into the lobe's shape; under its inverse the lamp is another polygon, whose irradiance
// is known. Matrices are fitted here to burnish's own lobes, one table a roughness, so that only the method is compared.
#pragma once

#include <burnish/light/area/convex_polygon.h>
#include <burnish/material/parameters.h>

#include <array>
#include <vector>

namespace burnish {

class LinearlyTransformedCosines {
public:
    explicit LinearlyTransformedCosines(const LobeParameters& lobe);

    /// Reflected luminance under unit radiance of a lamp that shines to both sides.
    float shade(const ConvexPolygon& lamp, const Vec3f& p, const Vec3f& n, const Vec3f& wo) const;

    /// Of the inverse: [1/a 0 -c/a; 0 1/b 0; 0 0 1] up to a factor, from M = [a 0 c; 0 b 0; 0 0 1] turned to the mean direction.
    struct Fit {
        float a = 1, b = 1, c = 0;
        float tilt = 0;    // radian: of the mean direction, away from the view
        float albedo = 1;  // directional
    };

private:
    std::vector<Fit> m_views;  // evenly over the angle of the view, 0 to 90 degrees
};

}  // namespace burnish
