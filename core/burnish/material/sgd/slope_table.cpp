#include <burnish/material/sgd/slope_table.h>

#include <algorithm>
#include <cmath>

namespace burnish {

SlopeTable::SlopeTable(const std::function<double(double x)>& density, double c, double end) {
    const double log_c = std::log(c), step = (std::log(c + end) - log_c) / kCells;
    const auto x_at = [&](double cell) { return std::expm1(cell * step) * c; };
    // Gauss' three points a cell, in ln(c + x)
    const auto mass = [&](int cell) {
        double sum = 0;
        for (const auto& [at, weight] :
             {std::pair{0.1127016653792583, 5.0 / 18}, {0.5, 8.0 / 18}, {0.8872983346207417, 5.0 / 18}}) {
            const double x = x_at(cell + at);
            sum += weight * density(x) * (c + x);
        }
        return sum * step;
    };
    std::array<double, kCells + 1> share{};
    for (int i = kCells - 1; i >= 0; --i) share[static_cast<size_t>(i)] = share[static_cast<size_t>(i) + 1] + mass(i);
    for (size_t i = 0; i <= kCells; ++i) {
        m_x[i] = static_cast<float>(x_at(static_cast<double>(i)));
        m_share[i] = share[i] / share[0];
    }
    for (size_t i = 0; i < kCells; ++i)
        m_density[i] = static_cast<float>((m_share[i] - m_share[i + 1]) / (m_x[i + 1] - m_x[i]));
    m_c = static_cast<float>(c), m_log_c = static_cast<float>(log_c), m_inv_step = static_cast<float>(1 / step);
}

float SlopeTable::density(float x) const {
    const float cell = (std::log(m_c + x) - m_log_c) * m_inv_step;
    return cell < kCells ? m_density[static_cast<size_t>(std::max(cell, 0.0f))] : 0.0f;
}

float SlopeTable::beyond(double xi) const {
    const auto after = std::upper_bound(m_share.begin() + 1, m_share.end() - 1, xi, std::greater<double>());
    const size_t cell = static_cast<size_t>(after - m_share.begin()) - 1;
    return m_x[cell] + static_cast<float>((m_share[cell] - xi) / m_density[cell]);
}

}  // namespace burnish
