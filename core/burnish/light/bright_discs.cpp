#include <burnish/light/bright_discs.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>

namespace burnish {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWidestAperture = 1.25 * kDegree;  // what is taken lies this close to its centre,
constexpr double kAperture = 2.5;                   // and within so many of its longest radii
constexpr double kSurround = 2;                     // outer radius, in apertures, of the ring that tells the surround
constexpr int kSteps = 4;                           // of closing in
constexpr double kLargestRadius = 0.9 * kDegree;    // along the longest axis
constexpr double kLeastShare = 0.01;                // of the picture's luminance; less does not show in a few lookups' error
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
Color3f surround(const PictureCells& cells, const Imath::V3d& centre, double aperture) {
    std::array<std::vector<std::pair<float, double>>, 3> ring;
    const double inner = std::cos(aperture);
    cells.visit_within(centre, kSurround * aperture, [&](const PictureCell& cell) {
        if (cell.direction.dot(centre) > inner) return;
        for (int k = 0; k < 3; ++k) ring[k].emplace_back(cell.rgb[k], cell.solid_angle);
    });
    Color3f level;
    for (int k = 0; k < 3; ++k) level[k] = static_cast<float>(quantile(ring[k], kSurroundQuantile));
    return level;
}

Imath::V3d above(const PictureCell& cell, const Color3f& level) {
    Imath::V3d excess;
    for (int k = 0; k < 3; ++k) excess[k] = std::max(cell.rgb[k] - level[k], 0.0f);
    return excess;
}

double luminance_of(const Imath::V3d& rgb) { return luminance(Color3f(Vec3f(rgb))); }

/// What an aperture holds above a surround.
struct Excess {
    Imath::V3d flux{0, 0, 0}, direction{0, 0, 0};  // direction: mean weighted by luminance, unit
    double luminance = 0;                          // of the flux
    Imath::V3d along{0, 0, 0}, across{0, 0, 0};    // half axes, see BrightDisc

    double longest_radius() const { return along.length(); }
    double area() const { return std::numbers::pi * along.length() * across.length(); }
};

/// Second moments of directions on the tangent plane, as sums until `finish`.
struct Moments {
    double weight = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0, bilinear = 0;

    void add(double w, double u, double v, double bilinear_variance) {
        weight += w, x += w * u, y += w * v, xx += w * u * u, yy += w * v * v, xy += w * u * v;
        bilinear += w * bilinear_variance;
    }
    /// Half axes of the ellipse of constant radiance with these moments: a disc of radius r has variance r^2 / 4 per axis.
    std::pair<Imath::V2d, Imath::V2d> half_axes() const {
        const double cx = x / weight, cy = y / weight, vx = xx / weight - cx * cx, vy = yy / weight - cy * cy,
                     vxy = xy / weight - cx * cy;
        const double mean = 0.5 * (vx + vy) + bilinear / weight, half_difference = std::hypot(0.5 * (vx - vy), vxy),
                     angle = 0.5 * std::atan2(2 * vxy, vx - vy);
        const Imath::V2d axis(std::cos(angle), std::sin(angle));
        return {axis * (2 * std::sqrt(mean + half_difference)),
                Imath::V2d(-axis.y, axis.x) * (2 * std::sqrt(mean - half_difference))};
    }
};

Excess excess(const PictureCells& cells, const Imath::V3d& centre, double aperture, const Color3f& level) {
    Excess sum;
    Moments moments;
    const Frame frame = Frame::around(Vec3f(centre));
    const Imath::V3d t(frame.t), b(frame.b);
    cells.visit_within(centre, aperture, [&](const PictureCell& cell) {
        const Imath::V3d flux = above(cell, level) * cell.solid_angle;
        const double weight = luminance_of(flux);
        sum.flux += flux, sum.luminance += weight, sum.direction += cell.direction * weight;
        moments.add(weight, cell.direction.dot(t), cell.direction.dot(b), cell.bilinear_variance);
    });
    if (!(sum.luminance > 0)) return sum;
    sum.direction.normalize();
    const auto [along, across] = moments.half_axes();
    sum.along = t * along.x + b * along.y, sum.across = t * across.x + b * across.y;
    return sum;
}

/// The excess around a peak. The aperture moves onto its centre and closes in on the core: the glow stays in the picture.
struct Found {
    Imath::V3d centre;
    double aperture = kWidestAperture;
    Color3f level;
    Excess inside;

    /// Stops where the aperture holds no disc's light: inside of a large lamp.
    Found(const PictureCells& cells, const Imath::V3d& peak, double total_luminance) : centre(peak) {
        for (int step = 0; step < kSteps; ++step) {
            if (step > 0) {
                centre = inside.direction;
                aperture = std::min(kWidestAperture, kAperture * inside.longest_radius());
            }
            level = surround(cells, centre, aperture);
            inside = excess(cells, centre, aperture, level);
            if (inside.luminance < kLeastShare * total_luminance || inside.longest_radius() > kLargestRadius) return;
        }
    }

    bool is_disc(double total_luminance) const {
        if (inside.luminance < kLeastShare * total_luminance) return false;
        return inside.longest_radius() <= kLargestRadius &&
               inside.luminance > kLeastContrast * luminance(level) * inside.area();
    }
};

/// All discs, largest first. A peak near one already looked at belongs to it.
std::vector<Found> find(const PictureCells& cells, double total_luminance) {
    std::vector<Found> discs;
    std::vector<Imath::V3d> done;
    const double near = std::cos(kWidestAperture);
    for (const PictureCell& peak : cells.brighter_than(kLeastPeak * total_luminance / (4 * std::numbers::pi))) {
        const auto belongs = [&](const Imath::V3d& centre) { return peak.direction.dot(centre) > near; };
        if (std::any_of(done.begin(), done.end(), belongs)) continue;
        const Found found(cells, peak.direction, total_luminance);
        const bool disc = found.is_disc(total_luminance);
        done.push_back(disc ? found.centre : peak.direction);
        if (disc) discs.push_back(found);
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
        const Excess& disc = found.inside;
        m_discs.push_back({Vec3f(disc.direction), Vec3f(disc.along), Vec3f(disc.across), Color3f(Vec3f(disc.flux))});
        cells.visit_within(found.centre, found.aperture, [&](const PictureCell& cell) {
            if (above(cell, found.level) == Imath::V3d(0, 0, 0)) return;
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
                      2 * disc.radius() / kDegree, 100 * luminance(disc.flux) / m_total_luminance);
        lines.emplace_back(line);
    }
    return lines;
}

}  // namespace burnish
