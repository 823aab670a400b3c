// What materials of other programs have in common: a base that is partly metal, a dielectric surface over it, and a coat over both; and
// how that becomes lobes.
//
// Metal and dielectric are mixed, each Schlick's curve from F at normal incidence to F at the horizon. The coat takes from what is below
// it the share F_coat that it reflects: F (1 - c F_coat), which is a curve of the same kind to first order, so that no lobe has to know
// of another. Both curves are of the angle to the microfacet: no energy is made up to 75 degrees, and beyond where the base is not much
// rougher than the coat.
#pragma once

#include <burnish/material/parameters.h>

#include <string>

namespace burnish {

/// How one interface reflects.
struct Interface {
    Color3f f0{0.04f, 0.04f, 0.04f}, f90{1, 1, 1};  // at normal incidence and at the horizon
    Vec2f alpha{0.01f, 0.01f};                      // GGX widths along t and b
    float rotation = 0;                             // radians, turns t about n, right-hand rule
};

struct SurfaceNumbers {
    Color3f base{1, 1, 1};  // diffuse reflectivity, and F of metal at normal incidence
    float metallic = 0;     // share of metal
    Interface dielectric;
    float transmission = 0;  // share of the dielectric's diffuse part that lets light through instead
    Color3f transmission_color{1, 1, 1};
    float coat_weight = 0;
    Interface coat;
    Color3f coat_color{1, 1, 1};  // what is below is seen through
};

/// F at normal incidence of a dielectric of index `ior` > 0.
float f0_of_ior(float ior);

/// Lobes of GGX and a coupled diffuse part.
Material material_of(const std::string& name, const SurfaceNumbers& numbers);

}  // namespace burnish
