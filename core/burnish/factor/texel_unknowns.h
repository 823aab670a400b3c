// Texels of all terms as the unknowns of a fit: those of the first term as logarithms, which keeps them above zero, those of further
// terms, which have signs, as they are.
#pragma once

#include <burnish/factor/sample_lookups.h>

namespace burnish {

struct TexelUnknowns {
    ColorRow share;  // what the first term's texels are multiples of; 0 in channels that are zero everywhere
    int positive;    // unknowns of the first term

    Colors texels(const Colors& x) const;
    /// Of the texels by their unknowns.
    Colors derivatives(const Colors& x) const;
    /// The unknowns of maps laid out like those of `layout`, looked up in `factors`, which may be of another size.
    Colors looked_up(const Factors& layout, const Factors& factors) const;
    void set_texels(Factors& factors, const Colors& x) const;
};

}  // namespace burnish
