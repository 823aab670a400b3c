// A factored function: maps of colour, and the product of lookups in them that stands for it.
#pragma once

#include <burnish/factor/direction_map.h>
#include <burnish/factor/factor_guide.h>
#include <burnish/factor/parametrization.h>

#include <functional>
#include <vector>

namespace burnish {

/// A BRDF in 1/sr, or radiance. May be called from several threads.
using PairFunction = std::function<Color3f(const DirectionPair&)>;

struct FactorMap {
    DirectionMap layout;
    std::vector<Color3f> texels;  // layout.texels() of them; linear, below zero only in terms after the first

    Color3f lookup(const Vec3f& d) const;
};

/// One product of the sum: a map for each of the parametrisation's.
using FactorTerm = std::vector<FactorMap>;

struct Factors {
    const Parametrization* parametrization = nullptr;
    FactorGuide guide;
    bool holds_suns = true;         // of lighting: else the light's bright discs are left to the shader (bright_discs.h)
    std::vector<FactorTerm> terms;  // one, or more where a single product does not do; all of the same layouts

    /// BRDF in 1/sr, or radiance. Below zero never: what terms after the first take too much is cut off.
    Color3f operator()(const DirectionPair& pair) const;
};

/// Maps of `value` everywhere, one term: discs for directions above the horizon, `sphere` for those all around.
Factors uniform_factors(const Parametrization& parametrization, Mapping sphere, int size,
                        const Color3f& value = Color3f(1, 1, 1));

/// A function's value at a pair, and how much it counts for.
struct FactorSample {
    DirectionPair pair;
    Color3f value;
    float weight = 1;
};

}  // namespace burnish
