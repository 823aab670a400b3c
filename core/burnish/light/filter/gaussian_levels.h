// Which levels a Gaussian stack has, and what each is made from.
//
// Level 0 is the map as it is. From level 1 on the widths grow by sqrt(2), and from 1.6 degrees on, where levels are small, by its
// root, so that a blend of two is as good as a Gaussian. A texel at a face's centre is no wider than 3/4 sigma, then 1/2
// (sigma on level 1, the first that the map can hold). A level's width is that of its lookups: the texels' own area, the
// kernels and the bilinear tent together, as a mean versine (gaussian_width.h), which a blend of two levels keeps.
//
// Levels 1 and 2 are sums over texels, the next ones come from one sqrt(2) narrower by a few lookups a texel. Where the map at
// half its size has texels of a quarter of a dense level's width, that level is a sum over it instead, the next ones come from there,
// and so on with a quarter of its size: errors do not add up, and a wide level needs nothing of the fine ones. Levels wider than 1/3 are sums over one
// of a third of the width: there a Gaussian of a Gaussian is no Gaussian any more.
#pragma once

#include <vector>

namespace burnish {

struct GaussianLevel {
    int size;               // texels a side
    double sigma, versine;  // of its lookups
    /// What it is made from: sums over the map shrunk `halvings` times, sums over a level, or taps of a level.
    enum class Source { map, sums, taps } source = Source::map;
    int halvings = 0;  // of the map
    int from = 0;      // the level
};

/// For a map of this size, finest first; each comes from a level before it.
std::vector<GaussianLevel> gaussian_levels(int map_size);

}  // namespace burnish
