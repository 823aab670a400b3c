#include <burnish/light/filter/gaussian_width.h>

#include <cmath>

namespace burnish {

double versine_of_sigma(double sigma) {
    const double variance = sigma * sigma;
    return variance - 2.0 / std::expm1(2.0 / variance);
}

// Newton's steps on the variance, where it differs from the versine at all.
double sigma_of_versine(double versine) {
    constexpr double narrow = 0.05;  // exp(-2 / 0.05) is nothing
    double variance = versine;
    if (versine < narrow) return std::sqrt(variance);
    for (int step = 0; step < 20; ++step) {
        const double tail = 1.0 / std::sinh(1.0 / variance);
        const double slope = 1.0 - tail * tail / (variance * variance);
        variance += (versine - versine_of_sigma(std::sqrt(variance))) / slope;
    }
    return std::sqrt(variance);
}

}  // namespace burnish
