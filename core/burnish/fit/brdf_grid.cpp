#include <burnish/fit/brdf_grid.h>
#include <burnish/material/measured/half_difference.h>
#include <burnish/material/measured/merl_table.h>

#include <algorithm>

namespace burnish {

namespace {

constexpr double kPi2 = std::numbers::pi / 2;

/// cos(a) - cos(b) without cancellation.
double cosine_step(double a, double b) { return 2 * std::sin((a + b) / 2) * std::sin((b - a) / 2); }

std::optional<Channels> to_channels(const std::optional<Color3f>& f) {
    if (!f) return std::nullopt;
    return Channels{f->x, f->y, f->z};
}

BrdfGrid::Values values_of(const MeasuredBrdf& measured) {
    if (const auto* table = dynamic_cast<const MerlTable*>(&measured)) {
        return [table](const GridAngles& a) {
            const auto cell = [](double share, int count) { return std::min(static_cast<int>(share * count), count - 1); };
            return to_channels(
                table->at({cell(std::sqrt(a.theta_h / kPi2), MerlTable::kThetaH), cell(a.theta_d / kPi2, MerlTable::kThetaD),
                           cell(a.phi_d / std::numbers::pi, MerlTable::kPhiD)}));
        };
    }
    return [&measured](const GridAngles& a) {
        const auto [wo, wi] = directions(
            HalfDifference{static_cast<float>(a.theta_h), 0, static_cast<float>(a.theta_d), static_cast<float>(a.phi_d)});
        return to_channels(measured.eval(wo, wi));
    };
}

}  // namespace

BrdfGrid::BrdfGrid(const GridSize& size, const Values& values) : m_size(size) {
    const auto border = [&](double h) { return kPi2 * std::pow(h / size.theta_h, size.power); };
    for (int h = 0; h < size.theta_h; ++h) {
        m_theta_h.push_back(border(h + 0.5));
        const double ring = 2 * std::numbers::pi * cosine_step(border(h), border(h + 1));
        for (int d = 0; d < size.theta_d && theta_d(d) < kTrustedDifference; ++d) {
            const double half_step = kPi2 / size.theta_d / 2;
            const double band = cosine_step(theta_d(d) - half_step, theta_d(d) + half_step) * 4 * std::cos(theta_d(d));
            add_row(h, d, ring * band * 2 * std::numbers::pi / size.phi_d, values);
        }
    }
}

BrdfGrid::BrdfGrid(const GridSize& size, const MeasuredBrdf& measured) : BrdfGrid(size, values_of(measured)) {}

void BrdfGrid::add_row(int h, int d, double row_weight, const Values& values) {
    const double lowest = std::cos(kTrustedElevation);
    const double level = std::cos(m_theta_h[h]) * std::cos(theta_d(d)), tilt = std::sin(m_theta_h[h]) * std::sin(theta_d(d));
    for (int p = 0; p < m_size.phi_d; ++p) {
        const double lean = tilt * std::cos(phi_d(p)), cos_i = level - lean, cos_o = level + lean;
        if (cos_i < lowest || cos_o < lowest) continue;
        const auto f = values({m_theta_h[h], theta_d(d), phi_d(p)});
        if (!f) continue;
        m_cells.push_back({h, d, p, cos_i, cos_o, row_weight * cos_i * cos_o});
        for (int channel = 0; channel < 3; ++channel) m_f[channel].push_back((*f)[channel]);
    }
}

BrdfGrid BrdfGrid::subset(const std::function<bool(const Cell&)>& wanted) const {
    BrdfGrid part = *this;
    part.m_cells.clear();
    for (auto& f : part.m_f) f.clear();
    for (size_t j = 0; j < m_cells.size(); ++j) {
        if (!wanted(m_cells[j])) continue;
        part.m_cells.push_back(m_cells[j]);
        for (int channel = 0; channel < 3; ++channel) part.m_f[channel].push_back(m_f[channel][j]);
    }
    return part;
}

double BrdfGrid::max_albedo(int channel) const {
    constexpr int kRings = 16;  // up to the trusted elevation
    const double step = kTrustedElevation / kRings;
    std::array<double, kRings> flux{};  // integral of f cos_i cos_o over wi and the ring of wo
    for (size_t j = 0; j < m_cells.size(); ++j) {
        const Cell& cell = m_cells[j];
        for (const double cosine : {cell.cos_i, cell.cos_o}) {  // either direction may be the view
            const int ring = static_cast<int>(std::acos(std::min(cosine, 1.0)) / step);
            flux[std::min(ring, kRings - 1)] += 0.5 * cell.weight * m_f[channel][j];
        }
    }
    double greatest = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double low = std::sin(ring * step), high = std::sin((ring + 1) * step);
        greatest = std::max(greatest, flux[ring] / (std::numbers::pi * (high * high - low * low)));
    }
    return greatest;
}

}  // namespace burnish
