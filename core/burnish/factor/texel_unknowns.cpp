#include <burnish/factor/texel_unknowns.h>

namespace burnish {
namespace {

constexpr float kLargest = 40;  // of a logarithm: what no sample holds down stays finite

}  // namespace

Colors TexelUnknowns::texels(const Colors& x) const {
    Colors t = x;
    t.topRows(positive) = x.topRows(positive).array().min(kLargest).max(-kLargest).exp().rowwise() * share;
    return t;
}

Colors TexelUnknowns::derivatives(const Colors& x) const {
    Colors d = texels(x);
    d.bottomRows(d.rows() - positive).setOnes();
    return d;
}

Colors TexelUnknowns::looked_up(const Factors& layout, const Factors& factors) const {
    std::vector<ColorRow> rows;
    for (size_t term = 0; term < factors.terms.size(); ++term)
        for (size_t map = 0; map < factors.terms[term].size(); ++map) {
            const DirectionMap& place = layout.terms[term][map].layout;
            for (int texel = 0; texel < place.texels(); ++texel) {
                const Color3f t = factors.terms[term][map].lookup(place.direction(texel));
                const ColorRow row(t.x, t.y, t.z, 0);
                rows.push_back(term > 0 ? row : (share > 0).select((row / share).log(), 0.0f));
            }
        }
    Colors x(static_cast<Eigen::Index>(rows.size()), 4);
    for (size_t row = 0; row < rows.size(); ++row) x.row(static_cast<Eigen::Index>(row)) = rows[row];
    return x;
}

void TexelUnknowns::set_texels(Factors& factors, const Colors& x) const {
    const Colors t = texels(x);
    Eigen::Index row = 0;
    for (FactorTerm& term : factors.terms)
        for (FactorMap& map : term)
            for (Color3f& texel : map.texels) {
                texel = {t(row, 0), t(row, 1), t(row, 2)};
                ++row;
            }
}

}  // namespace burnish
