#include <burnish/factor/polish.h>

#include <burnish/base/parallel.h>

#include <array>

namespace burnish {
namespace {

constexpr int kMostFactors = 32;  // of all terms
constexpr int kHalvings = 7;

ColorRow value_of(const FactorSample& sample) { return {sample.value.x, sample.value.y, sample.value.z, 0}; }

/// A sample's lookups, and the sum of products they make.
struct Product {
    std::array<ColorRow, kMostFactors> lookup;
    ColorRow sum = ColorRow::Zero();

    Product(const Colors& texels, std::span<const BlendedTexels> blends, int factors) {
        for (size_t first = 0; first < blends.size(); first += factors) {
            ColorRow product = ColorRow::Ones();
            for (size_t j = first; j < first + factors; ++j) product *= lookup[j] = blended(texels, blends[j]);
            sum += product;
        }
    }

    /// The derivative by the lookup of a factor: the other lookups of its term.
    ColorRow others(int factor, int factors) const {
        ColorRow product = ColorRow::Ones();
        const int first = factor / factors * factors;
        for (int j = first; j < first + factors; ++j)
            if (j != factor) product *= lookup[j];
        return product;
    }
};

}  // namespace

Polish::Sums Polish::error(const Colors& x, const Colors& weight) const {
    const Colors texels = unknowns.texels(x);
    const int factors = lookups.factors() / lookups.terms();
    std::array<Sums, SampleLookups::kChunks> parts;
    for_each_index(SampleLookups::kChunks, [&](int chunk) {
        Sums sum = Sums::Zero();
        for (int s = lookups.chunk_begin(chunk); s < lookups.chunk_begin(chunk + 1); ++s) {
            const Product product(texels, lookups.of(s), factors);
            const ColorRow residual = measure(product.sum, value_of(samples[s])).residual;
            sum += (measure.loss(residual) * samples[s].weight).cast<double>();
        }
        parts[chunk] = sum;
    });
    for (int chunk = 1; chunk < SampleLookups::kChunks; ++chunk) parts[0] += parts[chunk];
    return parts[0] + (R * x).cwiseProduct(x).cwiseProduct(weight).cast<double>().colwise().sum().array();
}

BlendSystem Polish::linearised(const Colors& x) const {
    const int all = lookups.factors(), factors = all / lookups.terms();
    const Colors texels = unknowns.texels(x);
    BlendSystem system{lookups, R, Colors(static_cast<Eigen::Index>(lookups.samples()) * all, 4), Colors(lookups.samples(), 4),
                       unknowns.derivatives(x)};
    const Colors dx = system.d.cwiseProduct(x);
    for_each_index(SampleLookups::kChunks, [&](int chunk) {
        for (int s = lookups.chunk_begin(chunk); s < lookups.chunk_begin(chunk + 1); ++s) {
            const auto blends = lookups.of(s);
            const Product product(texels, blends, factors);
            const auto measured = measure(product.sum, value_of(samples[s]));
            const ColorRow weight = (measure.weight(measured.residual) * samples[s].weight).sqrt();
            ColorRow b = -measured.residual * weight;
            for (int j = 0; j < all; ++j) {
                const ColorRow c = product.others(j, factors) * measured.slope * weight;
                system.c.row(static_cast<Eigen::Index>(s) * all + j) = c;
                b += c * blended(dx, blends[j]);
            }
            system.b.row(s) = b;
        }
    });
    return system;
}

/// As much of a change as makes the error less, for each channel on its own.
Colors Polish::taken(const Colors& x, const Colors& change, const Colors& weight, Sums& least) const {
    ColorRow length = ColorRow::Ones();
    for (int halving = 0; halving < kHalvings; ++halving) {
        const Colors next = x + (change.array().rowwise() * length).matrix();
        const Sums after = error(next, weight);
        const auto is_less = (after <= least).eval();
        if (is_less.all()) {
            least = after;
            return next;
        }
        const float shorter = halving + 2 < kHalvings ? 0.5f : 0.0f;
        length = is_less.select(length, length * shorter);
    }
    return x;
}

Colors Polish::operator()(Colors x, const Progress& progress) const {
    constexpr SolveLimits kLimits = {30, 1e-2f};
    constexpr double kSettled = 1e-3;
    constexpr int kLeast = 5, kMost = 12;  // steps; new terms start slowly
    for (int step = 0; step < kMost; ++step) {
        progress.report("factor", static_cast<float>(step) / kMost);
        const BlendSystem system = linearised(x);
        const Colors weight = smoothness_weight(lookups, sample_diagonal(system));
        const Sums before = error(x, weight);
        Sums after = before;
        x = taken(x, solve(system, x, kLimits) - x, weight, after);
        if (step + 1 >= kLeast && (after >= before * (1 - kSettled)).all()) break;
    }
    return x;
}

}  // namespace burnish
