#include <burnish/fit/slices/lobe_shape.h>

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

constexpr double kPiD = std::numbers::pi;

double square(double x) { return x * x; }

double tan2(double theta) { return square(std::tan(theta)); }

double inverse_cos4(double theta) { return 1 / square(square(std::cos(theta))); }

/// Without its norm, 1 where x = 0.
double sgd_P22(double alpha, double p, double x) { return std::exp(-x / alpha - p * std::log1p(x / square(alpha))); }

double sgd_D(Shape n, double theta_h) { return sgd_P22(n[0], n[1], tan2(theta_h)) * inverse_cos4(theta_h); }

/// Integral of f(x) P22(x) dx over x in [low, high], by Simpson's rule in u of ln(alpha^2 + x) = t0 + (t1 - t0) u^2, which spreads
/// the power law below alpha, the exponential beyond, and the root that masking begins with at `low`.
template <class F>
double sgd_integral(double alpha, double p, double low, double high, const F& f) {
    constexpr int kSteps = 64;
    const double t0 = std::log(square(alpha) + low), t1 = std::log(square(alpha) + high);
    double sum = 0;
    for (int j = 1; j <= kSteps; ++j) {
        const double u = static_cast<double>(j) / kSteps, shifted = std::exp(t0 + (t1 - t0) * square(u));
        const double x = std::max(low, shifted - square(alpha));
        sum += (j == kSteps ? 1 : j % 2 ? 4 : 2) * f(x) * sgd_P22(alpha, p, x) * shifted * u;
    }
    return sum * 2 * (t1 - t0) / (3 * kSteps);
}

/// Smith's, with Lambda = integral of s^2 P22(s^2) 2 A(mu / s) ds / (pi mu) over slopes s > mu = cot(theta),
/// A(c) = sqrt(1 - c^2) - c acos(c).
std::vector<double> sgd_G1(Shape n, std::span<const double> theta) {
    constexpr double kFarTail = 40;
    const double alpha = n[0], p = n[1], end = kFarTail * alpha;
    const double norm = sgd_integral(alpha, p, 0, end, [](double) { return 1.0; });
    std::vector<double> G1;
    for (const double t : theta) {
        const double mu = 1 / std::tan(t), begin = square(mu);
        const double beyond = begin >= end ? 0 : sgd_integral(alpha, p, begin, begin + end, [&](double x) {
            const double c = std::min(1.0, mu / std::sqrt(x));
            return std::sqrt(x) * (std::sqrt(1 - c * c) - c * std::acos(c));
        });
        G1.push_back(1 / (1 + beyond / (norm * kPiD * mu)));
    }
    return G1;
}

/// Eq. V.3 with c and theta0 expressed by where it begins to fall: 1 at pi/2 - reach, 0 at pi/2.
double sgd_free_G1(Shape n, double theta) {
    const double lambda = n[2], u = 1 - (kPiD / 2 - theta) / n[3];
    return u <= 0 ? 1 : std::max(0.0, 1 - lambda * std::expm1(std::log1p(1 / lambda) * std::pow(u, n[4])));
}

/// A closed form of one angle as a table.
template <double (*G1)(Shape, double)>
std::vector<double> tabulate(Shape n, std::span<const double> theta) {
    std::vector<double> table;
    for (const double t : theta) table.push_back(G1(n, t));
    return table;
}

double beckmann_D(Shape n, double theta_h) { return std::exp(-tan2(theta_h) / square(n[0])) * inverse_cos4(theta_h); }

double beckmann_G1(Shape n, double theta) {
    const double a = 1 / (n[0] * std::tan(theta));
    return a < 1.6 ? (3.535 + 2.181 * a) * a / (1 + (2.276 + 2.577 * a) * a) : 1;
}

double ggx_D(Shape n, double theta_h) {
    const double m2 = square(n[0]);
    return square(m2 / (square(std::sin(theta_h)) + m2 * square(std::cos(theta_h))));
}

double ggx_G1(Shape n, double theta) {
    const double z = std::cos(theta);
    return 2 * z / (z + std::hypot(n[0] * std::sin(theta), z));
}

double abc_D(Shape n, double theta_h) { return std::exp(-n[1] * std::log1p(n[0] * 2 * square(std::sin(theta_h / 2)))); }

const FamilyNumber kAlpha{"alpha", 1e-6, 5, true, 20}, kPower{"p", 0, 2.5, false, 9}, kWidth{"m", 1e-4, 1, true, 40};

}  // namespace

const ShapeFamily* shape_family(std::string_view model) {
    static const std::vector<ShapeFamily> families{
        {"sgd", {kAlpha, kPower}, Masking::smith, sgd_D, sgd_G1},
        {"beckmann", {kWidth}, Masking::smith, beckmann_D, tabulate<beckmann_G1>},
        {"ggx", {kWidth}, Masking::smith, ggx_D, tabulate<ggx_G1>},
        {"abc", {{"B", 1, 1e8, true, 20}, {"C", 0.05, 10, true, 12}}, Masking::grooves, abc_D, nullptr},
    };
    const auto found = std::find_if(families.begin(), families.end(), [&](const ShapeFamily& f) { return f.model == model; });
    return found == families.end() ? nullptr : &*found;
}

const ShapeFamily& sgd_with_free_masking() {
    static const ShapeFamily family{
        "sgd",
        {kAlpha, kPower, {"lambda", 1e-3, 1e3, true, 1}, {"reach", 0.3, 2.5, true, 1}, {"k", 1, 60, true, 1}},
        Masking::smith,
        sgd_D,
        tabulate<sgd_free_G1>};
    return family;
}

ShapeGrid::ShapeGrid(const BrdfGrid& grid) : m_theta_h(grid.theta_h()) {
    for (int k = 0; k <= kAngles; ++k) m_angles.push_back(std::clamp(k * kPiD / 2 / kAngles, 1e-9, kPiD / 2 - 1e-9));
    for (const BrdfGrid::Cell& cell : grid.cells()) {
        const double cos_h = std::cos(m_theta_h[cell.h]), cos_d = std::cos(grid.theta_d(cell.d));
        m_cells.push_back({cell.h, place(cell.cos_i), place(cell.cos_o), 1 / (4 * cell.cos_i * cell.cos_o),
                           std::min(1.0, 2 * cos_h * std::min(cell.cos_i, cell.cos_o) / cos_d)});
    }
}

ShapeGrid::Place ShapeGrid::place(double cosine) {
    const double at = std::acos(std::min(cosine, 1.0)) / (kPiD / 2) * kAngles;
    const int node = std::clamp(static_cast<int>(at), 1, kAngles - 2);
    return {node, static_cast<float>(at - node)};
}

void ShapeGrid::evaluate(const ShapeFamily& family, Shape numbers, std::vector<double>& S) const {
    std::vector<double> D(m_theta_h.size());
    for (size_t h = 0; h < D.size(); ++h) D[h] = family.D(numbers, m_theta_h[h]);
    S.resize(m_cells.size());
    if (family.masking == Masking::grooves) {
        for (size_t j = 0; j < S.size(); ++j) S[j] = D[m_cells[j].h] * m_cells[j].grooves * m_cells[j].scale;
        return;
    }
    const std::vector<double> G1 = family.G1(numbers, m_angles);
    const auto masked = [&](const Place& place) {  // Catmull & Rom's cubic
        const double a = place.along, p0 = G1[place.node - 1], p1 = G1[place.node], p2 = G1[place.node + 1],
                     p3 = G1[place.node + 2];
        return p1 + 0.5 * a * (p2 - p0 + a * (2 * p0 - 5 * p1 + 4 * p2 - p3 + a * (3 * (p1 - p2) + p3 - p0)));
    };
    for (size_t j = 0; j < S.size(); ++j) {
        const CellGeometry& cell = m_cells[j];
        S[j] = D[cell.h] * masked(cell.i) * masked(cell.o) * cell.scale;
    }
}

}  // namespace burnish
