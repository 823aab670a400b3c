#include <burnish/factor/blend_system.h>

#include <burnish/base/parallel.h>

#include <functional>

namespace burnish {
namespace {

using Sums = Eigen::Array<double, 1, 4>;

Sums dot(const Colors& a, const Colors& b) { return a.cast<double>().cwiseProduct(b.cast<double>()).colwise().sum().array(); }

/// The sum over samples of their rows times what `of_sample` tells: A^T of it.
template <class OfSample>
Colors gathered(const BlendSystem& system, const OfSample& of_sample) {
    const SampleLookups& lookups = system.lookups;
    const int factors = lookups.factors();
    std::vector<Colors> parts(SampleLookups::kChunks);
    for_each_index(SampleLookups::kChunks, [&](int chunk) {
        Colors sum = Colors::Zero(lookups.texels(), 4);
        for (int s = lookups.chunk_begin(chunk); s < lookups.chunk_begin(chunk + 1); ++s) {
            const auto blends = lookups.of(s);
            const auto* c = &system.c(static_cast<Eigen::Index>(s) * factors, 0);
            const ColorRow q = of_sample(s, blends, c);
            for (int j = 0; j < factors; ++j) {
                const ColorRow cq = Eigen::Map<const ColorRow>(c + 4 * j) * q;
                for (int i = 0; i < 4; ++i) sum.row(blends[j].texel[i]).array() += cq * blends[j].weight[i];
            }
        }
        parts[chunk] = std::move(sum);
    });
    for (int chunk = 1; chunk < SampleLookups::kChunks; ++chunk) parts[0] += parts[chunk];
    return parts[0].cwiseProduct(system.d);
}

Colors right_side(const BlendSystem& system) {
    return gathered(system, [&](int s, auto&&, auto*) { return ColorRow(system.b.row(s)); });
}

/// The diagonal of A^T A, leaving out that a row may read a texel twice.
Colors sample_diagonal(const BlendSystem& system) {
    const SampleLookups& lookups = system.lookups;
    Colors sum = Colors::Zero(lookups.texels(), 4);
    for (int s = 0; s < lookups.samples(); ++s) {
        const auto blends = lookups.of(s);
        for (size_t j = 0; j < blends.size(); ++j) {
            const ColorRow c = system.c.row(static_cast<Eigen::Index>(s) * lookups.factors() + j);
            for (int i = 0; i < 4; ++i)
                sum.row(blends[j].texel[i]).array() += c * c * (blends[j].weight[i] * blends[j].weight[i]);
        }
    }
    return sum.cwiseProduct(system.d).cwiseProduct(system.d);
}

/// A^T A + weight R, per channel.
class NormalMatrix {
public:
    explicit NormalMatrix(const BlendSystem& system) : m_system(system), m_diagonal(sample_diagonal(system)) {
        m_weight = m_diagonal.colwise().mean() * system.weight;
        for (int channel = 0; channel < 4; ++channel)
            m_diagonal.col(channel) += m_weight[channel] * Eigen::VectorXf(system.R.diagonal());
    }

    Colors operator*(const Colors& x) const {
        const Colors dx = m_system.d.cwiseProduct(x);
        Colors y = gathered(m_system, [&](int, std::span<const BlendedTexels> blends, const float* c) {
            ColorRow q = ColorRow::Zero();
            for (size_t j = 0; j < blends.size(); ++j) q += Eigen::Map<const ColorRow>(c + 4 * j) * blended(dx, blends[j]);
            return q;
        });
        const Colors Rx = m_system.R * x;
        y.array() += Rx.array().rowwise() * m_weight;
        return y;
    }

    /// What a simple preconditioner makes of a gradient; 0 for texels that nothing tells of.
    Colors over_diagonal(const Colors& r) const {
        return (m_diagonal.array() > 0).select(r.array() / m_diagonal.array(), 0.0f).matrix();
    }

private:
    const BlendSystem& m_system;
    Colors m_diagonal;
    ColorRow m_weight;
};

}  // namespace

Colors solve(const BlendSystem& system, Colors x, const SolveLimits& limits) {
    const NormalMatrix N(system);
    const Colors g = right_side(system);
    const Sums least = dot(g, N.over_diagonal(g)) * (static_cast<double>(limits.tolerance) * limits.tolerance);
    Colors r = g - N * x, p = N.over_diagonal(r);
    Sums rz = dot(r, p);
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
