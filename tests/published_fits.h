// Stand-ins for measurements that may not be passed on: published fits to the MERL tables, as functions of two directions.
//
//     nbrdf_merl_80.csv       neural fits (Sztrajman et al. 2021): relu layers of 21, input half and difference vector, exp(.) - 1
//     sgd_bagher2012.csv      f = rhoD/pi + rhoS/pi F(theta_d) D(theta_h) G1 G1 / (cos_i cos_o), channel by channel (Bagher et al. 2012)
#pragma once

#include <burnish/material/measured/half_difference.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace burnish::published {

/// One row of a CSV file with a header, its numbers by the names of the columns; `material` is the first column.
struct Row {
    std::string material;
    std::vector<double> values;           // in the order of the columns
    std::map<std::string, double> named;  // those that are numbers
};

inline std::vector<Row> read_rows(const std::string& file) {
    std::ifstream stream(file);
    std::string line;
    const auto cells = [&] {
        std::vector<std::string> list;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');) list.push_back(cell);
        return list;
    };
    if (!std::getline(stream, line)) throw std::runtime_error(file + ": cannot be read");
    const std::vector<std::string> names = cells();
    std::vector<Row> rows;
    while (std::getline(stream, line)) {
        const std::vector<std::string> row = cells();
        Row& added = rows.emplace_back();
        added.material = row.at(0);
        for (size_t i = 1; i < row.size(); ++i) {
            char* end = nullptr;
            const double value = std::strtod(row[i].c_str(), &end);
            if (end == row[i].c_str()) continue;
            added.values.push_back(value), added.named[names.at(i)] = value;
        }
    }
    return rows;
}

inline const Row& row_of(const std::vector<Row>& rows, const std::string& material) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.material == material; });
    if (found == rows.end()) throw std::runtime_error("no fit of " + material);
    return *found;
}

/// The network of a row of nbrdf_merl_80.csv.
class Neural {
public:
    explicit Neural(const Row& row) : m_weights(row.values.begin(), row.values.end()) {
        m_weights.resize(6 * 21 + 21 + 21 * 21 + 21 + 21 * 3 + 3);
    }

    Color3f operator()(const Vec3f& wo, const Vec3f& wi) const {
        const HalfDifference a = half_difference(wo, wi);
        const float sin_d = std::sin(a.theta_d);
        const std::array<float, 6> x{std::sin(a.theta_h),       0,
                                     std::cos(a.theta_h),       sin_d * std::cos(a.phi_d),
                                     sin_d * std::sin(a.phi_d), std::cos(a.theta_d)};
        const float* weights = m_weights.data();
        std::array<float, 21> first{}, second{};
        std::array<float, 3> out{};
        layer(x, first, weights);
        for (float& value : first) value = std::max(value, 0.0f);
        layer(first, second, weights);
        for (float& value : second) value = std::max(value, 0.0f);
        layer(second, out, weights);
        for (float& value : out) value = std::max(std::exp(value) - 1, 0.0f);
        return {out[0], out[1], out[2]};
    }

private:
    /// W row by row of the input, then b.
    template <size_t In, size_t Out>
    static void layer(const std::array<float, In>& in, std::array<float, Out>& out, const float*& weights) {
        const float* bias = weights + In * Out;
        for (size_t j = 0; j < Out; ++j) {
            out[j] = bias[j];
            for (size_t i = 0; i < In; ++i) out[j] += in[i] * weights[i * Out + j];
        }
        weights = bias + Out;
    }

    std::vector<float> m_weights;
};

/// A row of sgd_bagher2012.csv.
class ShiftedGamma {
public:
    explicit ShiftedGamma(const Row& row) {
        constexpr const char* kChannels[] = {"_r", "_g", "_b"};
        for (size_t c = 0; c < 3; ++c) {
            const auto at = [&](const char* name) { return row.named.at(std::string(name) + kChannels[c]); };
            m_channels[c] = {at("rhoD"), at("rhoS"),   at("alpha"), at("p"), at("F0"),    at("F1"),
                             at("kap"),  at("lambda"), at("c"),     at("k"), at("theta0")};
        }
    }

    Color3f operator()(const Vec3f& wo, const Vec3f& wi) const {
        const HalfDifference a = half_difference(wo, wi);
        Color3f f;
        for (int c = 0; c < 3; ++c)
            f[c] = static_cast<float>(m_channels[static_cast<size_t>(c)].f(a.theta_h, a.theta_d, wo.z, wi.z));
        return f;
    }

private:
    struct Channel {
        double rho_d, rho_s, alpha, p, f0, f1, kap, lambda, c, k, theta0;

        double shadowing(double cosine) const {
            const double from = std::max(std::acos(std::min(cosine, 1.0)) - theta0, 0.0);
            return std::clamp(1 + lambda * (1 - std::exp(c * std::pow(from, k))), 0.0, 1.0);
        }
        double f(double theta_h, double theta_d, double cos_o, double cos_i) const {
            const double t2 = std::pow(std::tan(theta_h), 2), ax = alpha + t2 / alpha, cos4 = std::pow(std::cos(theta_h), 4);
            const double D = kap * std::exp(-ax) / (std::numbers::pi * std::pow(ax, p) * cos4), cos_d = std::cos(theta_d);
            const double F = f0 - f1 * cos_d + (1 - f0) * std::pow(1 - cos_d, 5);
            const double gloss = F * D * shadowing(cos_o) * shadowing(cos_i) / (cos_o * cos_i);
            return std::max((rho_d + rho_s * gloss) / std::numbers::pi, 0.0);
        }
    };
    std::array<Channel, 3> m_channels;
};

}  // namespace burnish::published
