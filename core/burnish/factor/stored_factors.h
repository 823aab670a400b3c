// Factors as files hold them: the maps, how they lie in the world, and what they were made of.
//
// The JSON beside the maps rebuilds the formula without burnish (docs/factored.md):
//
//     {"format": 1, "of": "lighting", "parametrization": "nr", "formula": "L(n, wo) = gain * normal(n) * reflection(reflection_of(n, wo))",
//      "factors": [{"direction": "normal", "map": "normal"}, ...], "maps": [{"name": "normal", "mapping": "double_parabolic", "size": 32}, ...],
//      "terms": 1, "dominant": [0, 0, 1], "reflection_curve": [[0, 1], [0.03125, 1], ...], "world_to_map": [[1, 0, 0], ...], "gain": 1,
//      "made_of": {...}}
#pragma once

#include <burnish/factor/factors.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace burnish {

struct StoredFactors {
    Factors factors;
    Matrix33f world_to_map;  // of lighting: world direction -> axes of the maps, as row vector times matrix
    Color3f gain{1, 1, 1};   // multiplies what the maps give
    std::string made_of;     // JSON object: material, light, errors; "" = nothing is known

    /// Lighting: (n, wo) in world axes, radiance. BRDF: as Factors.
    Color3f operator()(const DirectionPair& pair) const;
};

/// What a map is called in files and shaders: the first direction that it is looked up by; "normal_2" of the second term.
std::string map_name(const Parametrization& parametrization, int map, size_t term = 0);

nlohmann::json factors_to_json(const StoredFactors& stored);
/// Maps are laid out, but hold no texels yet. Throws Error(bad_argument) naming field, expected and found, where it is not of this form,
/// is of a later format, or does not fit the parametrisation it names.
StoredFactors factors_from_json(const nlohmann::json& value, const std::string& where);

}  // namespace burnish
