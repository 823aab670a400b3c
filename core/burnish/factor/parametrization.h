// Parametrisations: by which directions the maps of a factored function are looked up.
//
//     f(a, b) = sum over terms of  product over j of  t_k(j)( project_j(a, b) )                    (Factor 18, 24, 45)
//
// For a BRDF (a, b) = (wi, wo) in the surface's frame, for lighting (n, wo) in the axes of the maps. All of it is data: the rows of two
// tables in parametrization.cpp, the directions with their projections in C++ and in GLSL, and the parametrisations made of them.
#pragma once

#include <burnish/base/types.h>
#include <burnish/factor/direction_map.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// What is factored: a BRDF over (wi, wo), or what a material reflects of a light over (n, wo).
enum class FactoredFunction { brdf, lighting };

/// Unit vectors.
struct DirectionPair {
    Vec3f a, b;
};

/// A direction that maps are looked up by. `dominant`: where most of the light comes from, unit; of no use to most.
struct ProjectedDirection {
    std::string_view name;
    FactoredFunction of;
    bool is_whole_sphere;  // else z >= 0
    bool needs_dominant;
    Vec3f (*project)(const DirectionPair& pair, const Vec3f& dominant);
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

    int map_count() const;
    bool needs_dominant() const;
    /// Whether some factor that reads this map needs the whole sphere.
    bool is_whole_sphere(int map) const;
    /// How many factors read this map: f(k) of Factor 4.3.1.
    int uses(int map) const;
};

std::span<const ProjectedDirection> projected_directions();
std::span<const Parametrization> parametrizations();
/// Throws Error(bad_argument) with the known names and the nearest one.
const Parametrization& parametrization_by_name(std::string_view name);

/// GLSL functions that the expressions of ProjectedDirection::glsl call.
std::string_view glsl_projections();

}  // namespace burnish
