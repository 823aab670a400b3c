#include <burnish/sampling/lobe_pattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace burnish {
namespace {

constexpr double kPi2 = 2 * std::numbers::pi;
constexpr int kMaxCircles = 256;
constexpr float kExtremeAspect = 8.0f;      // beyond it a line covers the lobe better than circles (tests/bench)

double border_radius(float border) { return std::sqrt(-std::log(static_cast<double>(border))); }

/// Samples of one circle of radius r about the wider axis, in normalised slopes of a lobe with this aspect.
LobePattern circle(double r, int count, double turn, float aspect) {
    LobePattern samples;
    const double wide = std::max(aspect, 1.0f), tall = std::max(1.0f / aspect, 1.0f);   // max(m) / mx is `tall`
    for (int k = 0; k < count; ++k) {
        const double phi = kPi2 * (k + turn) / count;
        samples.push_back({static_cast<float>(r * std::cos(phi) * tall), static_cast<float>(r * std::sin(phi) * wide), 0});
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

/// Shares the lobe's area out equally, as the source does.
LobePattern with_equal_areas(LobePattern pattern, double radius) {
    const float area = static_cast<float>(std::numbers::pi * radius * radius / pattern.size());
    for (PatternSample& s : pattern) s.area = area;
    return pattern;
}


/// The circles whose count comes nearest to `samples`; earlier candidates win ties.
LobePattern nearest_circles(PatternKind kind, int samples, float aspect, float border) {
    constexpr std::array<int, 3> with_centre{6, 5, 7}, without_centre{4, 5, 3};     // the source's own first
    LobePattern best;
    const auto distance = [&](const LobePattern& p) { return std::abs(static_cast<int>(p.size()) - samples); };
    for (const bool centred : {true, false}) {
        if ((kind == PatternKind::circles && !centred) || (kind == PatternKind::offset_circles && centred)) continue;
        for (const int first : centred ? with_centre : without_centre) {
            int count = 0;
            for (int circles = 1; count < samples && circles < kMaxCircles; ++circles) {
                LobePattern pattern = circle_pattern(circles, first, centred, aspect, border);
                count = static_cast<int>(pattern.size());
                if (best.empty() || distance(pattern) < distance(best)) best = std::move(pattern);
            }
        }
    }
    return best;
}

}  // namespace

LobePattern circle_pattern(int circles, int first, bool centred, float aspect, float border) {
    const double radius = border_radius(border), first_radius = centred ? 1.0 : std::numbers::sqrt2 / 2;
    const double spacing = radius / (centred ? circles - 0.5 : circles - 0.5 + first_radius);
    LobePattern pattern;
    if (centred) pattern.push_back({0, 0, 0});
    for (int i = 0; i < (centred ? circles - 1 : circles); ++i) {
        const double r = first_radius + i;
        const int count = i == 0 ? first : 2 * static_cast<int>(std::floor(first * r / (2 * first_radius) + 0.5));
        LobePattern straight = circle(r * spacing, count, 0.0, aspect), turned = circle(r * spacing, count, 0.5, aspect);
        const double straight_sum = keep_within(straight, radius), turned_sum = keep_within(turned, radius);
        const LobePattern& kept = turned_sum > straight_sum * (1 + 1e-6) ? turned : straight;
        pattern.insert(pattern.end(), kept.begin(), kept.end());
    }
    return with_equal_areas(std::move(pattern), radius);
}

LobePattern ring_pattern(int n, float border) {
    LobePattern pattern = circle(border_radius(0.6f), n - 1, 0.0, 1.0f);
    pattern.insert(pattern.begin(), {0, 0, 0});
    return with_equal_areas(std::move(pattern), border_radius(border));
}

LobePattern line_pattern(int n, float aspect, float border) {
    const double radius = border_radius(border), step = 2 * radius / n;
    const float area = static_cast<float>(step * std::sqrt(std::numbers::pi));    // the narrow profile exp(-v^2) has this width
    LobePattern pattern;
    for (int k = 0; k < n; ++k) {
        const float along = static_cast<float>(-radius + (k + 0.5) * step);
        pattern.push_back(aspect >= 1 ? PatternSample{along, 0, area} : PatternSample{0, along, area});
    }
    return pattern;
}

LobePattern regular_pattern(PatternKind kind, int samples, float aspect, float border) {
    const float xi0 = border > 0 ? border : default_border(samples);
    if (kind == PatternKind::automatic && std::max(aspect, 1 / aspect) > kExtremeAspect) kind = PatternKind::line;
    if (kind == PatternKind::ring) return ring_pattern(std::max(samples, 2), xi0);
    if (kind == PatternKind::line) return line_pattern(samples, aspect, xi0);
    return nearest_circles(kind, samples, aspect, xi0);
}

float default_border(int samples) { return std::clamp(1.9f / samples, 0.002f, 0.4f); }

LobePattern stretched(const LobePattern& pattern, const std::function<float(float xi)>& radius_of) {
    LobePattern mapped = pattern;
    for (PatternSample& s : mapped) {
        const float r2 = s.u * s.u + s.v * s.v, r = std::sqrt(r2);
        const float low = std::max(r - 0.01f, 0.0f), high = r + 0.01f;
        const float inner = radius_of(std::exp(-low * low)), outer = radius_of(std::exp(-high * high));
        const float scale = r > 1e-4f ? radius_of(std::exp(-r2)) / r : outer / high;
        s.area *= (outer * outer - inner * inner) / (high * high - low * low);
        s.u *= scale, s.v *= scale;
    }
    return mapped;
}

}  // namespace burnish
