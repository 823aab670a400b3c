// The lobes of a material that are worth their cost.
#pragma once

#include <burnish/material/parameters.h>

#include <numeric>
#include <vector>

namespace burnish {

/// Places in Material::lobes, ascending.
using LobeChoice = std::vector<size_t>;

inline LobeChoice all_lobes(const Material& material) {
    LobeChoice all(material.lobes.size());
    std::iota(all.begin(), all.end(), size_t{0});
    return all;
}

/// The material with these lobes alone.
inline Material with_lobes(const Material& material, const LobeChoice& lobes) {
    Material result = material;
    result.lobes.clear();
    for (const size_t lobe : lobes) result.lobes.push_back(material.lobes[lobe]);
    return result;
}

}  // namespace burnish
