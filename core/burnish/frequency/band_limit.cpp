#include <burnish/frequency/band_limit.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burnish {
namespace {

float top_of_band(int band) { return std::ldexp(0.5f, -band); }

}  // namespace

float energy_band_limit(std::span<const float> energies, float constant, float quantile, int octaves) {
    const int last = static_cast<int>(energies.size()) - 1;
    const auto top = [&](int band, float coarser) {
        return energies[band] > 0.0f ? top_of_band(band) * std::sqrt(energies[band] / (energies[band] + coarser)) : 0.0f;
    };
    float finer = 0.0f;
    for (int band = 0; band < last; ++band) {
        finer += energies[band];
        const int end = std::min(band + octaves, last);
        const float all = std::accumulate(&energies[band + 1], &energies[end] + 1, finer + constant);
        if (finer > (1.0f - quantile) * all) return top(band, energies[band + 1]);
    }
    return top(last, constant);
}

float maxima_band_limit(std::span<const float> squares, float constant, float epsilon) {
    const float largest = std::sqrt(std::max(constant, *std::max_element(squares.begin(), squares.end())));
    float finer = 0.0f;
    for (int band = 0; band < static_cast<int>(squares.size()); ++band) {
        finer += std::sqrt(squares[band]);
        if (finer > epsilon * largest) return top_of_band(band);
    }
    return 0.0f;
}

}  // namespace burnish
