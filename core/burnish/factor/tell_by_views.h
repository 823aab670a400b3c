// Two terms over the view's elevation, told by what they are: what is reflected seen from above, and seen near the horizon.
//
// A sum of two products t_1(r) g_1(z) + t_2(r) g_2(z) stays what it is under any change of basis. In the basis of two views the maps are
// what these views see, which is nothing below zero, and the curves share other views out between the two.
#pragma once

#include <burnish/factor/factors.h>

namespace burnish {

/// Changes the basis of two terms of a parametrisation of two maps, one of them of elevation; leaves all others as they are. The function
/// stays the same to a part in some hundreds, where both views see the same light, else to rounding.
void tell_by_views(Factors& factors);

}  // namespace burnish
