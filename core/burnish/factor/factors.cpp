#include <burnish/factor/factors.h>

#include <algorithm>

namespace burnish {
namespace {

Mapping mapping_of(DirectionDomain domain, Mapping sphere) {
    switch (domain) {
        case DirectionDomain::sphere: return sphere;
        case DirectionDomain::hemisphere: return Mapping::parabolic;
        default: return Mapping::elevation;
    }
}

}  // namespace

Color3f FactorMap::lookup(const Vec3f& d) const {
    const BlendedTexels blend = layout.lookup(d);
    Color3f sum(0, 0, 0);
    for (size_t i = 0; i < blend.texel.size(); ++i) sum += texels[blend.texel[i]] * blend.weight[i];
    return sum;
}

Color3f Factors::operator()(const DirectionPair& pair) const {
    Color3f sum(0, 0, 0);
    for (const FactorTerm& term : terms) {
        Color3f product(1, 1, 1);
        for (const Factor& factor : parametrization->factors)
            product *= term[factor.map].lookup(factor.direction->project(pair, guide));
        sum += product;
    }
    return {std::max(sum.x, 0.0f), std::max(sum.y, 0.0f), std::max(sum.z, 0.0f)};
}

Factors uniform_factors(const Parametrization& parametrization, Mapping sphere, int size, const Color3f& value) {
    FactorTerm term;
    for (int map = 0; map < parametrization.map_count(); ++map) {
        const DirectionMap layout(mapping_of(parametrization.domain(map), sphere), size);
        term.push_back({layout, std::vector<Color3f>(layout.texels(), value)});
    }
    Factors factors;
    factors.parametrization = &parametrization;
    factors.terms.push_back(std::move(term));
    return factors;
}

}  // namespace burnish
