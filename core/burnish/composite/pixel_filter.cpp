#include <burnish/composite/pixel_filter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burnish {
namespace {

constexpr double kPi2 = 2 * std::numbers::pi;

struct Usual {
    std::string_view name;
    float width;
};

const Usual& usual(FilterKind kind) {
    static constexpr std::array<Usual, 5> kinds{
        {{"auto", 1.0f}, {"box", 1.0f}, {"triangle", 2.0f}, {"gaussian", 2.0f}, {"blackman_harris", 1.5f}}};
    return kinds[static_cast<size_t>(kind)];
}

FilterKind default_of(Renderer renderer) {
    if (renderer == Renderer::cycles) return FilterKind::blackman_harris;
    return renderer == Renderer::arnold || renderer == Renderer::renderman ? FilterKind::gaussian : FilterKind::box;
}

/// Integrals from the left end to `u`, where u runs from -1 to 1 over the filter; not normalised.
double triangle_integral(double u) { return 0.5 + u - 0.5 * u * std::abs(u); }

double gaussian_integral(double u) { return std::erf(std::numbers::sqrt2) + std::erf(std::numbers::sqrt2 * u); }

/// Of the four-term window.
double blackman_harris_integral(double u) {
    constexpr std::array terms{0.35875, -0.48829, 0.14128, -0.01168};
    const double t = 0.5 * (u + 1);
    double sum = terms[0] * t;
    for (size_t k = 1; k < terms.size(); ++k) sum += terms[k] * std::sin(kPi2 * k * t) / (kPi2 * k);
    return sum;
}

double integral(FilterKind kind, double u) {
    switch (kind) {
        case FilterKind::triangle: return triangle_integral(u);
        case FilterKind::gaussian: return gaussian_integral(u);
        case FilterKind::blackman_harris: return blackman_harris_integral(u);
        case FilterKind::automatic:
        case FilterKind::box: break;
    }
    return 0.5 * (u + 1);
}

}  // namespace

std::string_view filter_name(FilterKind kind) { return usual(kind).name; }

PixelFilter settled(PixelFilter filter, Renderer renderer) {
    if (filter.kind == FilterKind::automatic) filter.kind = default_of(renderer);
    if (filter.width == 0) filter.width = usual(filter.kind).width;
    return filter;
}

double PixelFilter::reach() const { return kind == FilterKind::blackman_harris ? width : 0.5 * width; }

double PixelFilter::share_below(double x) const {
    return integral(kind, std::clamp(x / reach(), -1.0, 1.0)) / integral(kind, 1.0);
}

FilterTaps filter_taps(const PixelFilter& filter, int factor) {
    constexpr double kRounding = 1e-6;  // a filter that ends at the border of a sample does not reach the next
    FilterTaps taps;
    taps.reach = std::max(static_cast<int>(std::ceil((filter.reach() - 0.5) * factor - kRounding)), 0);
    for (int i = -taps.reach; i < factor + taps.reach; ++i) {
        const double left = static_cast<double>(i) / factor - 0.5;
        taps.weights.push_back(static_cast<float>(filter.share_below(left + 1.0 / factor) - filter.share_below(left)));
    }
    return taps;
}

}  // namespace burnish
