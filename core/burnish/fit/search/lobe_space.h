// The numbers of a lobe that a search may change, as data: their names, ranges and how to set them. Any model of models.def has
// one, so that searches need not know models.
#pragma once

#include <burnish/fit/fit_settings.h>

#include <functional>
#include <vector>

namespace burnish {

/// One number of a lobe's shape.
struct ShapeParameter {
    std::string name;  // in a material's JSON; "m" sets both widths
    NumberRange range;
    bool logarithmic;
    std::function<void(LobeParameters&, float)> set;
    std::function<float(const LobeParameters&)> get;

    /// The value at `unit` in [0, 1] of the range, evenly in ratio if logarithmic; and back.
    float at(double unit) const;
    double unit(float value) const;
};

/// All lobes a search looks at: the free numbers of their shape, and the ranges of the two that p is linear in, ks and ks r0.
struct LobeSpace {
    LobeParameters base;  // what does not change; tint 1
    std::vector<ShapeParameter> shape;
    NumberRange strength, r0;
    bool has_fresnel;  // false: the model knows none, or r0 is of no effect, see lobe_space.cpp

    /// Free numbers of one grey lobe.
    int parameters() const;
    /// The lobe of this shape, each number at `units[i]` of its range.
    LobeParameters at(const std::vector<double>& units) const;
};

/// Gives a lobe whose width follows from its other numbers that width, and what its model computes once.
void settle_width(LobeParameters& lobe);

/// Of the `number`-th lobe (1 is the first) on a side of the surface. Round lobes have one width, "m", unless bounds name "mx" or "my".
/// Throws Error(bad_argument) for bounds of parameters the model does not have, or outside what it allows.
LobeSpace lobe_space(ModelId model, Side side, int number, bool round, const ParameterBounds& bounds);

/// The bounds of `name` for lobe `number`: of "number.name", else of "name", else null.
const NumberRange* find_bounds(const ParameterBounds& bounds, int number, const std::string& name);

}  // namespace burnish
