#include <burnish/sampling/lobe_pattern.h>

#include <burnish/sampling/tuned_patterns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace burnish {
namespace {

constexpr double kPi2 = 2 * std::numbers::pi;
constexpr int kMaxCircles = 256;
constexpr float kExtremeAspect = 8.0f;  // beyond it a line covers the lobe better than circles (tests/bench)

/// Samples of one circle of radius r about the wider axis, in normalised slopes of a lobe with this aspect; they share `area`.
LobePattern circle(double r, int count, double turn, float aspect, double area) {
    LobePattern samples;
    const double wide = std::max(aspect, 1.0f), tall = std::max(1.0f / aspect, 1.0f);  // max(m) / mx is `tall`
    for (int k = 0; k < count; ++k) {
        const double phi = kPi2 * (k + turn) / count;
        samples.push_back({static_cast<float>(r * std::cos(phi) * tall), static_cast<float>(r * std::sin(phi) * wide),
                           static_cast<float>(area / count)});
    }
    return samples;
}

/// Sum of the relative densities exp(-(u^2 + v^2)) of the samples within the border; the others are dropped.
double keep_within(LobePattern& samples, double radius) {
    std::erase_if(samples, [&](const PatternSample& s) { return s.u * s.u + s.v * s.v > radius * radius * 1.0001; });
    double sum = 0;
    for (const PatternSample& s : samples) sum += std::exp(-(s.u * s.u + s.v * s.v));
    return sum;
}

/// Scales the areas so that they fill the disc of this radius.
LobePattern filling(LobePattern pattern, double radius) {
    double total = 0;
    for (const PatternSample& s : pattern) total += s.area;
    for (PatternSample& s : pattern) s.area *= static_cast<float>(std::numbers::pi * radius * radius / total);
    return pattern;
}

/// Maps the Gaussian radii w to the lobe's own; areas follow.
LobePattern stretched(LobePattern pattern, const RadiusOf& radius_of) {
    for (PatternSample& s : pattern) {
        const float r2 = s.u * s.u + s.v * s.v, r = std::sqrt(r2);
        const float low = std::max(r - 0.01f, 0.0f), high = r + 0.01f;
        const float inner = radius_of(std::exp(-low * low)), outer = radius_of(std::exp(-high * high));
        const float scale = r > 1e-4f ? radius_of(std::exp(-r2)) / r : outer / high;
        s.area *= (outer * outer - inner * inner) / (high * high - low * low);
        s.u *= scale, s.v *= scale;
    }
    return pattern;
}

/// Length of the circle of Gaussian radius w in units of the spacing there, up to a factor: r / (dr/dw); w itself for Gaussian lobes.
double relative_length(double w, const RadiusOf& radius_of) {
    const auto radius = [&](double at) { return static_cast<double>(radius_of(static_cast<float>(std::exp(-at * at)))); };
    return 0.02 * radius(w) / (radius(w + 0.01) - radius(w - 0.01));
}

/// The circles whose count comes nearest to `samples`; earlier candidates win ties.
LobePattern nearest_circles(PatternKind kind, int samples, float aspect, float border, const RadiusOf& radius_of) {
    constexpr std::array<int, 3> with_centre{6, 5, 7}, without_centre{4, 5, 3};  // the source's own first
    LobePattern best;
    const auto distance = [&](const LobePattern& p) { return std::abs(static_cast<int>(p.size()) - samples); };
    for (const bool centred : {true, false}) {
        if ((kind == PatternKind::circles && !centred) || (kind == PatternKind::offset_circles && centred)) continue;
        for (const int first : centred ? with_centre : without_centre) {
            int count = 0;
            for (int circles = 1; count < samples && circles < kMaxCircles; ++circles) {
                LobePattern pattern = circle_pattern(circles, first, centred, aspect, border, radius_of);
                count = static_cast<int>(pattern.size());
                if (best.empty() || distance(pattern) < distance(best)) best = std::move(pattern);
            }
        }
    }
    return best;
}

}  // namespace

LobePattern circle_pattern(int circles, int first, bool centred, float aspect, float border, const RadiusOf& radius_of) {
    const double radius = gaussian_radius(border), first_radius = centred ? 1.0 : std::numbers::sqrt2 / 2;
    const double spacing = radius / (centred ? circles - 0.5 : circles - 0.5 + first_radius);
    LobePattern pattern;
    if (centred) pattern.push_back({0, 0, static_cast<float>(std::numbers::pi * spacing * spacing / 4)});
    for (int i = 0; i < (centred ? circles - 1 : circles); ++i) {
        const double w = (first_radius + i) * spacing, area = kPi2 * w * spacing;
        const double length = relative_length(w, radius_of) / relative_length(first_radius * spacing, radius_of);
        const int count = i == 0 ? first : 2 * static_cast<int>(std::floor(first * length / 2 + 0.5));
        LobePattern straight = circle(w, count, 0.0, aspect, area), turned = circle(w, count, 0.5, aspect, area);
        const double straight_sum = keep_within(straight, radius), turned_sum = keep_within(turned, radius);
        const LobePattern& kept = turned_sum > straight_sum * (1 + 1e-6) ? turned : straight;
        pattern.insert(pattern.end(), kept.begin(), kept.end());
    }
    return stretched(filling(std::move(pattern), radius), radius_of);
}

LobePattern ring_pattern(int n, float border, const RadiusOf& radius_of) {
    const double radius = gaussian_radius(border), area = std::numbers::pi * radius * radius / n;
    LobePattern pattern = circle(gaussian_radius(0.6f), n - 1, 0.0, 1.0f, area * (n - 1));
    pattern.insert(pattern.begin(), {0, 0, static_cast<float>(area)});
    return stretched(std::move(pattern), radius_of);
}

LobePattern rings_pattern(int n, float border, const RadiusOf& radius_of) {
    const int rings = static_cast<int>(std::sqrt(n - 1.0)), sparse = rings - (n - 1) % rings;
    const double spacing = gaussian_radius(border) / (rings + 0.5);
    LobePattern pattern{{0, 0, static_cast<float>(std::numbers::pi * spacing * spacing / 4)}};
    for (int i = 0; i < rings; ++i) {
        const double w = (i + 1) * spacing;
        const LobePattern ring =
            circle(w, (n - 1) / rings + (i >= sparse), static_cast<double>(i) / rings, 1.0f, kPi2 * w * spacing);
        pattern.insert(pattern.end(), ring.begin(), ring.end());
    }
    return stretched(std::move(pattern), radius_of);
}

LobePattern line_pattern(int n, float aspect, float border, const RadiusOf& radius_of) {
    const double radius = gaussian_radius(border), step = 2 * radius / n;
    const float area = static_cast<float>(step * std::sqrt(std::numbers::pi));  // the narrow profile exp(-v^2) has this width
    LobePattern pattern;
    for (int k = 0; k < n; ++k) {
        const float along = static_cast<float>(-radius + (k + 0.5) * step);
        pattern.push_back(aspect >= 1 ? PatternSample{along, 0, area} : PatternSample{0, along, area});
    }
    return stretched(std::move(pattern), radius_of);
}

PatternKind chosen_kind(PatternKind kind, int samples, float aspect, float border) {
    if (kind != PatternKind::automatic) return kind;
    if (border == 0 && is_tuned_better(samples, aspect)) return PatternKind::tuned;
    return std::max(aspect, 1 / aspect) > kExtremeAspect ? PatternKind::line : kind;
}

LobePattern regular_pattern(PatternKind wanted, int samples, float mx, float my, float border, const RadiusOf& radius_of) {
    const float aspect = mx / my;
    const PatternKind kind = chosen_kind(wanted, samples, aspect, border);
    if (kind == PatternKind::tuned) return tuned_pattern(samples, mx, my, lobe_tail(radius_of));
    const int rings_worth = kind == PatternKind::line ? 2 * samples : samples;  // a line reaches further with the same count
    const float xi0 = border > 0 ? border : default_border(rings_worth, radius_of);
    if (kind == PatternKind::ring) return ring_pattern(std::max(samples, 2), xi0, radius_of);
    if (kind == PatternKind::rings) return rings_pattern(std::max(samples, 2), xi0, radius_of);
    if (kind == PatternKind::line) return line_pattern(samples, aspect, xi0, radius_of);
    return nearest_circles(kind, samples, aspect, xi0, radius_of);
}

float gaussian_radius(float xi) { return std::sqrt(-std::log(xi)); }

float default_border(int samples, const RadiusOf& radius_of) {
    return std::clamp((lobe_tail(radius_of) == LobeTail::long_tail ? 0.85f : 1.5f) / samples, 0.001f, 0.4f);
}

}  // namespace burnish
