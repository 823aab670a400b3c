#include <burnish/factor/tell_by_views.h>

#include <array>
#include <cmath>

namespace burnish {
namespace {

/// Of the elevations' row: seen from above, and as near the horizon as there is much to see.
struct Views {
    size_t above, horizon;
};

/// One channel of both terms, in the basis of these views.
void change_basis(Factors& factors, size_t other, size_t elevation, const Views& views, int channel) {
    auto &t0 = factors.terms[0][other].texels, &t1 = factors.terms[1][other].texels;
    auto &g0 = factors.terms[0][elevation].texels, &g1 = factors.terms[1][elevation].texels;
    const double a0 = g0[views.above][channel], a1 = g1[views.above][channel];
    const double h0 = g0[views.horizon][channel], h1 = g1[views.horizon][channel];
    const double determinant = a0 * h1 - a1 * h0, size = std::hypot(a0, a1) * std::hypot(h0, h1);
    constexpr double kOneTerm = 1e-4;
    if (!(std::abs(determinant) > kOneTerm * size)) return;
    for (size_t i = 0; i < t0.size(); ++i) {
        const double x = t0[i][channel], y = t1[i][channel];
        t0[i][channel] = static_cast<float>(x * a0 + y * a1), t1[i][channel] = static_cast<float>(x * h0 + y * h1);
    }
    for (size_t i = 0; i < g0.size(); ++i) {
        const double x = g0[i][channel], y = g1[i][channel];
        g0[i][channel] = static_cast<float>((x * h1 - y * h0) / determinant);
        g1[i][channel] = static_cast<float>((y * a0 - x * a1) / determinant);
    }
}

}  // namespace

void tell_by_views(Factors& factors) {
    const auto& rows = factors.parametrization->factors;
    if (factors.terms.size() != 2 || rows.size() != 2 || factors.parametrization->map_count() != 2) return;
    for (const Factor& factor : rows) {
        const size_t elevation = static_cast<size_t>(factor.map), count = factors.terms[0][elevation].texels.size();
        if (factor.direction->domain != DirectionDomain::elevation) continue;
        constexpr size_t kNearHorizon = 32;  // part of the row, from its horizon
        for (int channel = 0; channel < 3; ++channel)
            change_basis(factors, 1 - elevation, elevation, {count - 1, 1 + count / kNearHorizon}, channel);
        return;
    }
}

}  // namespace burnish
