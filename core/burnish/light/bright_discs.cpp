#include <burnish/light/bright_discs.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>

namespace burnish {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kAperture = 1.25 * kDegree;      // what is taken lies this close to its centre
constexpr double kSurround = 2.5 * kDegree;       // outer radius of the ring that tells the surround
constexpr double kLargestRadius = 0.9 * kDegree;  // along the longest axis
constexpr double kLeastShare = 0.01;              // of the picture's luminance; less does not show in a few lookups' error
constexpr double kLeastPeak = 100;     // times the mean radiance: 1 % of the light within the largest radius has at least 162
constexpr double kLeastContrast = 10;  // mean radiance over the surround's
constexpr double kSurroundQuantile = 0.85;  // above the glow; a lamp wider than the aperture covers more of the ring
constexpr size_t kMostDiscs = 8;

/// The value below which `share` of the solid angle lies.
double quantile(std::vector<std::pair<float, double>>& values, double share) {
    std::sort(values.begin(), values.end());
    double total = 0;
    for (const auto& value : values) total += value.second;
    double below = 0;
    for (const auto& [value, omega] : values)
        if ((below += omega) >= share * total) return value;
    return values.empty() ? 0 : values.back().first;
}

/// Radiance around an aperture, per channel.
Color3f surround(const PictureCells& cells, const Imath::V3d& centre) {
    std::array<std::vector<std::pair<float, double>>, 3> ring;
    const double inner = std::cos(kAperture);
    cells.visit_within(centre, kSurround, [&](const PictureCell& cell) {
        if (cell.direction.dot(centre) > inner) return;
        for (int k = 0; k < 3; ++k) ring[k].emplace_back(cell.rgb[k], cell.solid_angle);
    });
    Color3f level;
    for (int k = 0; k < 3; ++k) level[k] = static_cast<float>(quantile(ring[k], kSurroundQuantile));
    return level;
}

/// What an aperture holds above a surround.
struct Excess {
    Imath::V3d flux{0, 0, 0}, direction{0, 0, 0};  // direction: mean weighted by luminance, unit
    double luminance = 0;                          // of the flux
    double variance = 0, longest_variance = 0;     // rad^2 per axis: mean of both axes, and of the longest

    double radius() const { return 2 * std::sqrt(variance); }  // a disc of radius r has variance r^2 / 4
};

double above(const PictureCell& cell, const Color3f& level, int k) { return std::max(cell.rgb[k] - level[k], 0.0f); }

double luminance_above(const PictureCell& cell, const Color3f& level) {
    return luminance(Color3f(above(cell, level, 0), above(cell, level, 1), above(cell, level, 2)));
}

Excess excess(const PictureCells& cells, const Imath::V3d& centre, const Color3f& level) {
    Excess sum;
    const Frame frame = Frame::around(Vec3f(centre));
    const Imath::V3d t(frame.t), b(frame.b);
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0, bilinear = 0;
    cells.visit_within(centre, kAperture, [&](const PictureCell& cell) {
        const double weight = luminance_above(cell, level) * cell.solid_angle, u = cell.direction.dot(t),
                     v = cell.direction.dot(b);
        for (int k = 0; k < 3; ++k) sum.flux[k] += above(cell, level, k) * cell.solid_angle;
        sum.luminance += weight, sum.direction += cell.direction * weight;
        x += weight * u, y += weight * v, xx += weight * u * u, yy += weight * v * v, xy += weight * u * v;
        bilinear += weight * cell.bilinear_variance;
    });
    if (!(sum.luminance > 0)) return sum;
    const double w = 1 / sum.luminance;
    x *= w, y *= w, xx = xx * w - x * x, yy = yy * w - y * y, xy = xy * w - x * y;
    sum.direction.normalize();
    sum.variance = 0.5 * (xx + yy) + bilinear * w;
    sum.longest_variance = sum.variance + std::hypot(0.5 * (xx - yy), xy);
    return sum;
}

/// The excess around a peak, its aperture moved onto its centre.
struct Found {
    Imath::V3d centre;
    Color3f level;
    Excess inside;

    /// Stops where the aperture holds no disc's light: inside of a large lamp.
    Found(const PictureCells& cells, const Imath::V3d& peak, double total_luminance) : centre(peak) {
        for (int step = 0; step < 3; ++step) {
            if (step > 0) centre = inside.direction;
            level = surround(cells, centre);
            inside = excess(cells, centre, level);
            if (inside.luminance < kLeastShare * total_luminance) return;
        }
    }

    bool is_disc(double total_luminance) const {
        if (inside.luminance < kLeastShare * total_luminance) return false;
        if (2 * std::sqrt(inside.longest_variance) > kLargestRadius) return false;
        const double radius = inside.radius();
        return inside.luminance > kLeastContrast * luminance(level) * std::numbers::pi * radius * radius;
    }
};

/// Centres and luminances of all discs, largest first. Peaks near one already looked at belong to it.
std::vector<Found> find(const PictureCells& cells, double total_luminance) {
    std::vector<Found> discs;
    std::vector<Imath::V3d> done;
    const auto near = [](const Imath::V3d& a, const Imath::V3d& b, double angle) { return a.dot(b) > std::cos(angle); };
    for (const PictureCell& peak : cells.brighter_than(kLeastPeak * total_luminance / (4 * std::numbers::pi))) {
        const Imath::V3d& d = peak.direction;
        if (std::any_of(done.begin(), done.end(), [&](const auto& other) { return near(d, other, 0.5 * kAperture); })) continue;
        if (std::any_of(discs.begin(), discs.end(), [&](const auto& disc) { return near(d, disc.centre, kAperture); }))
            continue;
        done.push_back(d);
        const Found found(cells, d, total_luminance);
        if (found.is_disc(total_luminance)) discs.push_back(found);
    }
    std::stable_sort(discs.begin(), discs.end(),
                     [](const auto& a, const auto& b) { return a.inside.luminance > b.inside.luminance; });
    return discs;
}

}  // namespace

DiscCut::DiscCut(const PictureCells& cells) : m_total_luminance(4 * std::numbers::pi * cells.mean_luminance()) {
    for (const Found& candidate : find(cells, m_total_luminance)) {
        if (m_discs.size() == kMostDiscs) break;
        const Found found(cells, candidate.centre, m_total_luminance);  // again: an overlapping disc may have gone
        if (!found.is_disc(m_total_luminance)) continue;
        m_discs.push_back(
            {Vec3f(found.inside.direction), static_cast<float>(found.inside.radius()), Color3f(Vec3f(found.inside.flux))});
        cells.visit_within(found.centre, kAperture, [&](const PictureCell& cell) {
            if (luminance_above(cell, found.level) <= 0) return;
            m_texels.push_back({cell.rgb, {cell.rgb[0], cell.rgb[1], cell.rgb[2]}});
            for (int k = 0; k < 3; ++k) cell.rgb[k] = std::min(cell.rgb[k], found.level[k]);
        });
    }
}

void DiscCut::put_back() {
    for (auto texel = m_texels.rbegin(); texel != m_texels.rend(); ++texel)
        for (int k = 0; k < 3; ++k) texel->rgb[k] = texel->whole[k];
    m_texels.clear();
}

std::vector<std::string> DiscCut::notes() const {
    std::vector<std::string> lines;
    for (const BrightDisc& disc : m_discs) {
        char line[128];
        std::snprintf(line, sizeof line, "sun or lamp of %.1f degrees, %.0f %% of the light, taken out of the map",
                      2 * disc.radius / kDegree, 100 * luminance(disc.flux) / m_total_luminance);
        lines.emplace_back(line);
    }
    return lines;
}

}  // namespace burnish
