// What a material reflects diffusely, seen from an angle. A coupled diffuse part gives way to the lobes: of the light it has only
// what they do not return,
//
//     kd(wo) = kd (1 - rho(wo)),    rho: the lobes' directional albedo, its mean over azimuths
//
// so that varnish darkens the wood below it where it shines (Walkthrough, light maps).
#pragma once

#include <burnish/material/parameters.h>

#include <vector>

namespace burnish {

class DiffuseReflectance {
public:
    /// Lobes count with their own numbers, whatever layers may say pixel by pixel.
    explicit DiffuseReflectance(const Material& material);

    /// cos_o: of the angle between normal and viewer, [0, 1].
    Color3f at(float cos_o) const;
    bool depends_on_view() const { return m_by_view.size() > 1; }

private:
    std::vector<Color3f> m_by_view;  // at equal steps of cos_o; one where it is the same for all
};

}  // namespace burnish
