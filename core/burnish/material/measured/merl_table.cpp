#include <burnish/base/parallel.h>
#include <burnish/material/measured/merl_holes.h>
#include <burnish/material/measured/merl_table.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr Imath::V3d kScale(1.0 / 1500, 1.15 / 1500, 1.66 / 1500);
constexpr double kUnmeasured = -1;
constexpr int kH = MerlTable::kThetaH, kD = MerlTable::kThetaD, kP = MerlTable::kPhiD;

size_t index_of(int h, int d, int p) { return static_cast<size_t>((h * kD + d) * kP + p); }

/// Two neighbouring middles and the share of the second.
struct Between {
    int first, second;
    float share;
};

/// Where `x`, in cells, lies between the middles of `count` cells in a row.
Between between(float x, int count) {
    const float from_middle = std::clamp(x - 0.5f, 0.0f, static_cast<float>(count - 1));
    const int first = std::min(static_cast<int>(from_middle), count - 2);
    return {first, first + 1, from_middle - static_cast<float>(first)};
}

Between around(float x, int count) {
    const float from_middle = x - 0.5f, floor = std::floor(from_middle);
    const int first = (static_cast<int>(floor) % count + count) % count;
    return {first, (first + 1) % count, from_middle - floor};
}

}  // namespace

MerlTable::MerlTable(const std::function<Color3f(const Vec3f&, const Vec3f&)>& f, const Progress& progress)
    : m_numbers(3 * kCells, kUnmeasured) {
    for_each_tile(kP, kH * kD, progress, "table", [&](const Window& tile) {
        for (int row = tile.y; row < tile.y + tile.height; ++row)
            for (int p = tile.x; p < tile.x + tile.width; ++p) {
                const DirectionPair pair = directions({row / kD, row % kD, p});
                if (!above_surface(pair.wo, pair.wi)) continue;
                const Color3f value = f(pair.wo, pair.wi);
                for (int c = 0; c < 3; ++c)
                    m_numbers[static_cast<size_t>(c) * kCells + index_of(0, row, p)] = value[c] / kScale[c];
            }
    });
    fill_from_numbers();
}

MerlTable::MerlTable(std::vector<double> numbers) : m_numbers(std::move(numbers)) { fill_from_numbers(); }

std::optional<Color3f> MerlTable::at(const Cell& cell) const { return at_index(index_of(cell.h, cell.d, cell.p)); }

std::optional<Color3f> MerlTable::at_index(size_t index) const {
    Color3f value;
    for (int c = 0; c < 3; ++c) {
        const double f = m_numbers[static_cast<size_t>(c) * kCells + index] * kScale[c];
        if (!(f >= 0 && f <= kLargestReflectance)) return std::nullopt;  // false for NaN as well
        value[c] = static_cast<float>(f);
    }
    return value;
}

DirectionPair MerlTable::directions(const Cell& cell) {
    const auto middle = [](int i) { return static_cast<float>(i) + 0.5f; };
    const float root = middle(cell.h) / kH;
    return burnish::directions({root * root * kPi / 2, 0, middle(cell.d) / kD * kPi / 2, middle(cell.p) / kP * kPi});
}

int MerlTable::measured_cells() const {
    int count = 0;
    for (int i = 0; i < kCells; ++i) count += at_index(static_cast<size_t>(i)).has_value();
    return count;
}

Color3f MerlTable::eval(const Vec3f& wo, const Vec3f& wi) const {
    if (!above_surface(wo, wi)) return Color3f(0);
    const HalfDifference angles = half_difference(wo, wi);
    const Between h = between(kH * std::sqrt(angles.theta_h * (2 / kPi)), kH), d = between(kD * angles.theta_d * (2 / kPi), kD),
                  p = around(kP * angles.phi_d / kPi, kP);
    const auto row = [&](int ih, int id) {
        return m_filled[index_of(ih, id, p.first)] * (1 - p.share) + m_filled[index_of(ih, id, p.second)] * p.share;
    };
    const auto plane = [&](int ih) { return row(ih, d.first) * (1 - d.share) + row(ih, d.second) * d.share; };
    return plane(h.first) * (1 - h.share) + plane(h.second) * h.share;
}

std::vector<BrdfSample> MerlTable::samples() const {
    constexpr int kStepD = 2, kStepP = 4;
    std::vector<BrdfSample> result;
    for (int h = 0; h < kH; ++h)
        for (int d = 0; d < kD; d += kStepD)
            for (int p = 0; p < kP; p += kStepP) {
                const DirectionPair pair = directions({h, d, p});
                if (!above_surface(pair.wo, pair.wi)) continue;
                if (const auto f = at({h, d, p})) result.push_back({pair.wo, pair.wi, *f});
            }
    return result;
}

void MerlTable::fill_from_numbers() {
    m_filled.resize(kCells);
    for_each_index(kH, [&](int h) {
        for (size_t i = index_of(h, 0, 0); i < index_of(h + 1, 0, 0); ++i) m_filled[i] = at_index(i).value_or(kHole);
    });
    fill_holes(m_filled);
}

}  // namespace burnish
