#include <burnish/factor/map_smoothness.h>

namespace burnish {
namespace {

using Entries = std::vector<Eigen::Triplet<float>>;

/// Appends the rows of one map whose first texel is the unknown `first`; returns the number of rows there are then.
int add_rows(Entries& entries, const DirectionMap& layout, int first, float smoothness, int row) {
    for (int texel = 0; texel < layout.texels(); ++texel, ++row) {
        const std::vector<int> neighbours = layout.neighbours(texel);
        entries.emplace_back(row, first + texel, smoothness);
        for (const int other : neighbours)
            entries.emplace_back(row, first + other, -smoothness / static_cast<float>(neighbours.size()));
    }
    for (const DirectionMap::Seam& seam : layout.seams()) {
        entries.emplace_back(row, first + seam.texel, 1.0f);
        for (int i = 0; i < 4; ++i) entries.emplace_back(row, first + seam.repeats.texel[i], -seam.repeats.weight[i]);
        ++row;
    }
    return row;
}

}  // namespace

Eigen::SparseMatrix<float, Eigen::RowMajor> map_smoothness(const Factors& factors, float smoothness) {
    Entries entries;
    int rows = 0, texels = 0;
    for (const FactorTerm& term : factors.terms)
        for (const FactorMap& map : term) {
            rows = add_rows(entries, map.layout, texels, smoothness, rows);
            texels += map.layout.texels();
        }
    Eigen::SparseMatrix<float, Eigen::RowMajor> L(rows, texels);
    L.setFromTriplets(entries.begin(), entries.end());
    return L.transpose() * L;
}

}  // namespace burnish
