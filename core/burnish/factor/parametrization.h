// Parametrisations: by which directions the maps of a factored function are looked up.
//
//     f(a, b) = sum over terms of  product over j of  t_k(j)( project_j(a, b) )                    (Factor 18, 24, 45)
//
// For a BRDF (a, b) = (wi, wo) in the surface's frame, for lighting (n, wo) in the axes of the maps. All of it is data: the rows of two
// tables in parametrization.cpp, the directions with their projections in C++ and in GLSL, and the parametrisations made of them.
#pragma once

#include <burnish/factor/factor_guide.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// What is factored: a BRDF over (wi, wo), or what a material reflects of a light over (n, wo).
enum class FactoredFunction { brdf, lighting };

/// Where directions may lie: anywhere, at z >= 0, or where all of the same z >= 0 are the same.
enum class DirectionDomain { sphere, hemisphere, elevation };

/// A direction that maps are looked up by.
struct ProjectedDirection {
    std::string_view name;
    FactoredFunction of;
    DirectionDomain domain;
    bool needs_dominant;  // FactorGuide::dominant
    Vec3f (*project)(const DirectionPair& pair, const FactorGuide& guide);
    std::string_view glsl;  // an expression of wi and wo, or of n, wo and dominant
};

struct Factor {
    const ProjectedDirection* direction;
    int map;  // which of the maps; several factors may share one
};

struct Parametrization {
    std::string name, summary;
    FactoredFunction of;
    std::vector<Factor> factors;
    /// Of BRDFs: the pair that a direction of the first map makes with another one, by which maps are sampled evenly. Below the
    /// surface where there is no such pair.
    DirectionPair (*pair_of)(const Vec3f& first, const Vec3f& second) = nullptr;
    int terms = 1;  // products that are summed, where nothing else is asked for

    int map_count() const;
    bool needs_dominant() const;
    /// Of the directions that this map is read by: the widest of their domains.
    DirectionDomain domain(int map) const;
    /// How many factors read this map: f(k) of Factor 4.3.1.
    int uses(int map) const;
};

std::span<const ProjectedDirection> projected_directions();
std::span<const Parametrization> parametrizations();
/// Throws Error(bad_argument) with the known names and the nearest one.
const Parametrization& parametrization_by_name(std::string_view name);

/// GLSL functions that the expressions of ProjectedDirection::glsl call. Those of lighting read a `vec2 reflection_curve[]` of
/// (towards_n, towards_r), which is to be declared before them.
std::string glsl_projections(FactoredFunction of);

}  // namespace burnish
