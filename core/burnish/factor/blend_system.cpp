#include <burnish/factor/blend_system.h>

#include <burnish/base/parallel.h>

namespace burnish {
namespace {

using Sums = Eigen::Array<double, 1, 4>;

Sums dot(const Colors& a, const Colors& b) { return a.cast<double>().cwiseProduct(b.cast<double>()).colwise().sum().array(); }

/// The sum of what chunks of samples add to texels.
template <class Add>
Colors sum_over_chunks(const SampleLookups& lookups, const Add& add) {
    std::vector<Colors> parts(SampleLookups::kChunks);
    for_each_index(SampleLookups::kChunks, [&](int chunk) {
        Colors sum = Colors::Zero(lookups.texels(), 4);
        for (int s = lookups.chunk_begin(chunk); s < lookups.chunk_begin(chunk + 1); ++s) add(s, lookups.of(s), sum);
        parts[chunk] = std::move(sum);
    });
    for (int chunk = 1; chunk < SampleLookups::kChunks; ++chunk) parts[0] += parts[chunk];
    return std::move(parts[0]);
}

/// A^T of what `of_sample` tells of each sample.
template <class OfSample>
Colors gathered(const BlendSystem& system, const OfSample& of_sample) {
    const int factors = system.lookups.factors();
    const Colors sum = sum_over_chunks(system.lookups, [&](int s, std::span<const BlendedTexels> blends, Colors& texels) {
        const auto c = system.c.middleRows(static_cast<Eigen::Index>(s) * factors, factors);
        const ColorRow q = of_sample(s, blends, c);
        for (int j = 0; j < factors; ++j) {
            const ColorRow cq = c.row(j).array() * q;
            for (int i = 0; i < 4; ++i) texels.row(blends[j].texel[i]).array() += cq * blends[j].weight[i];
        }
    });
    return sum.cwiseProduct(system.d);
}

Colors right_side(const BlendSystem& system) {
    return gathered(system, [&](int s, auto&&, auto&&) { return ColorRow(system.b.row(s)); });
}

/// A^T A + W R, per channel.
class NormalMatrix {
public:
    explicit NormalMatrix(const BlendSystem& system)
        : m_system(system), m_diagonal(sample_diagonal(system)), m_weight(smoothness_weight(system.lookups, m_diagonal)) {
        m_diagonal.array() += m_weight.array().colwise() * Eigen::VectorXf(system.R.diagonal()).array();
    }

    Colors operator*(const Colors& x) const {
        const Colors dx = m_system.d.cwiseProduct(x);
        const Colors y = gathered(m_system, [&](int, std::span<const BlendedTexels> blends, const auto& c) {
            ColorRow q = ColorRow::Zero();
            for (size_t j = 0; j < blends.size(); ++j) q += c.row(j).array() * blended(dx, blends[j]);
            return q;
        });
        return y + (m_system.R * x).cwiseProduct(m_weight);
    }

    /// What a simple preconditioner makes of a gradient; 0 for texels that nothing tells of.
    Colors over_diagonal(const Colors& r) const {
        return (m_diagonal.array() > 0).select(r.array() / m_diagonal.array(), 0.0f).matrix();
    }

private:
    const BlendSystem& m_system;
    Colors m_diagonal, m_weight;
};

}  // namespace

Colors sample_diagonal(const BlendSystem& system) {
    const int factors = system.lookups.factors();
    const Colors sum = sum_over_chunks(system.lookups, [&](int s, std::span<const BlendedTexels> blends, Colors& texels) {
        for (int j = 0; j < factors; ++j) {
            const ColorRow c2 = system.c.row(static_cast<Eigen::Index>(s) * factors + j).array().square();
            for (int i = 0; i < 4; ++i)
                texels.row(blends[j].texel[i]).array() += c2 * (blends[j].weight[i] * blends[j].weight[i]);
        }
    });
    return sum.cwiseProduct(system.d).cwiseProduct(system.d);
}

Colors smoothness_weight(const SampleLookups& lookups, const Colors& sample_diagonal) {
    Colors weight(sample_diagonal.rows(), 4);
    const std::span<const int> first = lookups.first_texels();
    for (size_t map = 0; map + 1 < first.size(); ++map) {
        const int count = first[map + 1] - first[map];
        const ColorRow mean = sample_diagonal.middleRows(first[map], count).colwise().mean();
        weight.middleRows(first[map], count).rowwise() = mean.matrix();
    }
    return weight;
}

Colors solve(const BlendSystem& system, Colors x, const SolveLimits& limits) {
    const NormalMatrix N(system);
    Colors r = right_side(system) - N * x, p = N.over_diagonal(r);
    Sums rz = dot(r, p);
    const Sums least = rz * (static_cast<double>(limits.tolerance) * limits.tolerance);
    for (int i = 0; i < limits.iterations && (rz > least).any(); ++i) {
        const Colors Np = N * p;
        const Sums pNp = dot(p, Np);
        const ColorRow alpha = (pNp > 0).select(rz / pNp, 0.0).cast<float>();
        x.array() += p.array().rowwise() * alpha;
        r.array() -= Np.array().rowwise() * alpha;
        const Colors z = N.over_diagonal(r);
        const Sums next = dot(r, z);
        const ColorRow beta = (rz > 0).select(next / rz, 0.0).cast<float>();
        p = z + (p.array().rowwise() * beta).matrix();
        rz = next;
    }
    return x;
}

}  // namespace burnish
