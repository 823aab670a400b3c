#include "merl_stand_ins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace merl {

using burnish::Channels;
using burnish::GridAngles;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kHidden = 21;

/// Columns of an SGD row, each three numbers.
enum Column { rho_d, rho_s, alpha, p, f0, f1, kap, lambda, c, k, theta0 };

/// One layer: the next `outputs` x inputs weights, input by input, then as many offsets.
template <int outputs, size_t inputs>
std::array<double, outputs> layer(const double*& weights, const std::array<double, inputs>& x) {
    std::array<double, outputs> y{};
    for (int j = 0; j < outputs; ++j) y[j] = weights[inputs * outputs + j];
    for (size_t i = 0; i < inputs; ++i)
        for (int j = 0; j < outputs; ++j) y[j] += x[i] * weights[i * outputs + j];
    weights += (inputs + 1) * outputs;
    return y;
}

std::array<double, kHidden> rectified(std::array<double, kHidden> y) {
    for (double& value : y) value = std::max(value, 0.0);
    return y;
}

}  // namespace

std::vector<Row> read_rows(const std::filesystem::path& csv) {
    std::ifstream file(csv);
    if (!file) throw std::runtime_error("no file " + csv.string());
    std::string line;
    std::getline(file, line);
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        Row row;
        std::getline(fields, row.material, ',');
        for (std::string field; std::getline(fields, field, ',');) row.numbers.push_back(std::strtod(field.c_str(), nullptr));
        rows.push_back(std::move(row));
    }
    return rows;
}

Channels sgd(const Row& row, const GridAngles& angles) {
    const double cos_h = std::cos(angles.theta_h), cos_d = std::cos(angles.theta_d);
    const double tilt = std::sin(angles.theta_h) * std::sin(angles.theta_d) * std::cos(angles.phi_d);
    const double cos_i = cos_h * cos_d - tilt, cos_o = cos_h * cos_d + tilt, tan_h = std::tan(angles.theta_h);
    Channels f{};
    for (int channel = 0; channel < 3; ++channel) {
        const auto of = [&](Column column) { return row.numbers[static_cast<size_t>(3 * column + channel)]; };
        const double x = of(alpha) + tan_h * tan_h / of(alpha);
        const double D = of(kap) * std::exp(-x) / (kPi * std::pow(x, of(p)) * std::pow(cos_h, 4));
        const double F = std::max(0.0, of(f0) - of(f1) * cos_d + (1 - of(f0)) * std::pow(1 - cos_d, 5));
        const auto G1 = [&](double cosine) {
            const double beyond = std::max(0.0, std::acos(std::min(1.0, cosine)) - of(theta0));
            return std::clamp(1 + of(lambda) * (1 - std::exp(of(c) * std::pow(beyond, of(k)))), 0.0, 1.0);
        };
        f[channel] = of(rho_d) / kPi + of(rho_s) / kPi * F * D * G1(cos_i) * G1(cos_o) / (cos_i * cos_o);
    }
    return f;
}

Channels network(const Row& row, const GridAngles& angles) {
    const double sin_d = std::sin(angles.theta_d);
    const std::array<double, 6> x{std::sin(angles.theta_h),       0,
                                  std::cos(angles.theta_h),       sin_d * std::cos(angles.phi_d),
                                  sin_d * std::sin(angles.phi_d), std::cos(angles.theta_d)};
    const double* weights = row.numbers.data();
    const auto first = rectified(layer<kHidden>(weights, x));
    const auto second = rectified(layer<kHidden>(weights, first));
    const auto y = layer<3>(weights, second);
    return {std::max(0.0, std::expm1(y[0])), std::max(0.0, std::expm1(y[1])), std::max(0.0, std::expm1(y[2]))};
}

}  // namespace merl
