#include <burnish/factor/tell_by_views.h>

#include <array>
#include <cmath>

namespace burnish {
namespace {

/// Of the elevations' row: seen from above, and as near the horizon as there is much to see.
struct Views {
    size_t above, horizon;
};

struct Shares {
    double above, horizon;
};

/// The old basis told in the new one.
struct Basis {
    double a0, a1, h0, h1;
};

/// What one elevation's old pair of numbers is in the new basis. Where both views see much the same, one may take what the other
/// gives: then they share by elevation, as far as the sum stays what it is to a part in a few hundred.
Shares shares(const std::array<double, 2>& old, const Basis& basis, const double* gram, double z) {
    const double determinant = basis.a0 * basis.h1 - basis.a1 * basis.h0,
                 size = std::hypot(basis.a0, basis.a1) * std::hypot(basis.h0, basis.h1);
    constexpr double kOneTerm = 1e-6, kEven = 1e-6;
    Shares exact{0, 0};
    if (std::abs(determinant) > kOneTerm * size)
        exact = {(old[0] * basis.h1 - old[1] * basis.h0) / determinant, (old[1] * basis.a0 - old[0] * basis.a1) / determinant};
    else  // one term: what is seen from above, scaled
        exact = {(old[0] * basis.a0 + old[1] * basis.a1) / std::max(basis.a0 * basis.a0 + basis.a1 * basis.a1, 1e-30), 0};
    const double all = exact.above + exact.horizon, even = kEven * (gram[0] + gram[2]);
    const double A = gram[0] + even, B = gram[1], C = gram[2] + even;
    const double x = gram[0] * exact.above + gram[1] * exact.horizon + even * all * z;
    const double y = gram[1] * exact.above + gram[2] * exact.horizon + even * all * (1 - z);
    const double d = A * C - B * B;
    return d > 0 ? Shares{(x * C - y * B) / d, (y * A - x * B) / d} : exact;
}

/// One channel of both terms, in the basis of these views.
void change_basis(Factors& factors, size_t other, size_t elevation, const Views& views, int channel) {
    auto &t0 = factors.terms[0][other].texels, &t1 = factors.terms[1][other].texels;
    auto &g0 = factors.terms[0][elevation].texels, &g1 = factors.terms[1][elevation].texels;
    const double a0 = g0[views.above][channel], a1 = g1[views.above][channel];
    const double h0 = g0[views.horizon][channel], h1 = g1[views.horizon][channel];
    double gram[3] = {0, 0, 0};  // of the maps in the new basis
    for (size_t i = 0; i < t0.size(); ++i) {
        const double x = t0[i][channel], y = t1[i][channel], above = x * a0 + y * a1, horizon = x * h0 + y * h1;
        t0[i][channel] = static_cast<float>(above), t1[i][channel] = static_cast<float>(horizon);
        gram[0] += above * above, gram[1] += above * horizon, gram[2] += horizon * horizon;
    }
    for (size_t i = 0; i < g0.size(); ++i) {
        const double z = static_cast<double>(i) / static_cast<double>(g0.size() - 1);
        const Shares found = shares({g0[i][channel], g1[i][channel]}, {a0, a1, h0, h1}, gram, z);
        g0[i][channel] = static_cast<float>(found.above), g1[i][channel] = static_cast<float>(found.horizon);
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
