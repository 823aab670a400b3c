// The rows of a factorisation: which texels every sample's product of lookups reads. All texels of all maps of all terms are unknowns,
// one after the other; a row blends four of them for each factor of each term.
// Internal.
#pragma once

#include <burnish/factor/factors.h>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace burnish {

/// Red, green, blue and nothing of texels or samples, one a row: a register wide.
using Colors = Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>;
using ColorRow = Eigen::Array<float, 1, 4>;

class SampleLookups {
public:
    /// Of maps laid out like those of `factors`.
    SampleLookups(const Factors& factors, std::span<const FactorSample> samples);

    int samples() const { return static_cast<int>(m_blends.size()) / factors(); }
    int factors() const { return m_terms * m_factors; }  // of all terms
    int terms() const { return m_terms; }
    int texels() const { return m_first.back(); }
    /// Where the texels of each map of each term begin, and where all end.
    std::span<const int> first_texels() const { return m_first; }

    /// One for each factor of a sample, term by term.
    std::span<const BlendedTexels> of(int sample) const {
        return {&m_blends[static_cast<size_t>(sample) * factors()], static_cast<size_t>(factors())};
    }

    /// Samples are worked on in chunks that do not depend on the threads there are.
    static constexpr int kChunks = 16;
    int chunk_begin(int chunk) const { return static_cast<int>(static_cast<int64_t>(samples()) * chunk / kChunks); }

private:
    int m_terms, m_factors;
    std::vector<int> m_first{0};
    std::vector<BlendedTexels> m_blends;
};

inline ColorRow blended(const Colors& texels, const BlendedTexels& blend) {
    ColorRow sum = texels.row(blend.texel[0]).array() * blend.weight[0];
    for (int i = 1; i < 4; ++i) sum += texels.row(blend.texel[i]).array() * blend.weight[i];
    return sum;
}

}  // namespace burnish
