#include <burnish/factor/sample_lookups.h>

#include <burnish/base/parallel.h>

namespace burnish {

SampleLookups::SampleLookups(const Factors& factors, std::span<const FactorSample> samples)
    : m_terms(static_cast<int>(factors.terms.size())), m_factors(static_cast<int>(factors.parametrization->factors.size())) {
    for (const FactorTerm& term : factors.terms)
        for (const FactorMap& map : term) m_first.push_back(m_first.back() + map.layout.texels());
    m_blends.resize(samples.size() * static_cast<size_t>(m_terms * m_factors));
    const auto& rows = factors.parametrization->factors;
    const int maps = factors.parametrization->map_count();
    for_each_index(kChunks, [&](int chunk) {
        for (int s = chunk_begin(chunk); s < chunk_begin(chunk + 1); ++s)
            for (int j = 0; j < m_factors; ++j) {
                const FactorMap& map = factors.terms[0][rows[j].map];
                const BlendedTexels blend = map.layout.lookup(rows[j].direction->project(samples[s].pair, factors.guide));
                for (int term = 0; term < m_terms; ++term) {
                    BlendedTexels& own = m_blends[(static_cast<size_t>(s) * m_terms + term) * m_factors + j];
                    own = blend;
                    for (int& texel : own.texel) texel += m_first[term * maps + rows[j].map];
                }
            }
    });
}

}  // namespace burnish
