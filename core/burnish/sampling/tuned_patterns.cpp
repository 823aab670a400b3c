#include <burnish/sampling/tuned_patterns.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <span>
#include <tuple>

namespace burnish {
namespace {

/// Energy per area of normalised slopes.
double density(const Orbit& orbit, LobeTail tail) {
    const double r2 = static_cast<double>(orbit.u) * orbit.u + static_cast<double>(orbit.v) * orbit.v;
    const double relative = tail == LobeTail::gaussian ? std::exp(-r2) : 1 / ((1 + r2) * (1 + r2));
    return relative / std::numbers::pi;
}

/// How badly an entry fits a request: the count counts first, then the anisotropy.
double mismatch(const TunedPattern& entry, int samples, float aspect) {
    const double octaves = std::abs(std::log2(entry.aspect / std::max(aspect, 1 / aspect)));
    const bool one_isotropic = (entry.aspect == 1) != (aspect == 1);
    return 1000.0 * std::abs(entry.samples - samples) + (one_isotropic ? 100 : 0) + octaves;
}

/// The entries, by m, that fit a request best.
std::span<const TunedPattern> nearest_family(int samples, float aspect, LobeTail tail) {
    const std::vector<TunedPattern>& table = tuned_patterns();
    const TunedPattern* best = nullptr;
    for (const TunedPattern& entry : table)
        if (entry.tail == tail && (!best || mismatch(entry, samples, aspect) < mismatch(*best, samples, aspect))) best = &entry;
    const auto is_other = [&](const TunedPattern& entry) {
        return std::tie(entry.tail, entry.samples, entry.aspect) != std::tie(best->tail, best->samples, best->aspect);
    };
    return {best, std::find_if(best, table.data() + table.size(), is_other)};
}

constexpr int kMostSamples = 12, kFewestSamples = 3, kFewestAnisotropic = 7;
constexpr float kWidestAspect = 2.0f;

}  // namespace

LobeTail lobe_tail(const RadiusOf& radius_of) {
    return radius_of(0.01f) > 2 * gaussian_radius(0.01f) ? LobeTail::long_tail : LobeTail::gaussian;
}

const std::vector<TunedPattern>& tuned_patterns() {
    static const std::vector<TunedPattern> table = {
#define BURNISH_TUNED_PATTERN(tail, samples, aspect, m, ...) {LobeTail::tail, samples, aspect, m, {__VA_ARGS__}},
#include <burnish/sampling/tuned_patterns.def>
#undef BURNISH_TUNED_PATTERN
    };
    return table;
}

LobePattern unfolded(const std::vector<Orbit>& orbits, LobeTail tail) {
    LobePattern pattern;
    for (const Orbit& orbit : orbits) {
        const double area = std::numbers::pi * std::exp2(2.0 * orbit.level);
        const float weight = static_cast<float>(orbit.share / (density(orbit, tail) * area));
        for (const float u : {orbit.u, -orbit.u}) {
            for (const float v : {orbit.v, -orbit.v}) {
                pattern.push_back({u, v, static_cast<float>(area), weight});
                if (orbit.v == 0) break;
            }
            if (orbit.u == 0) break;
        }
    }
    return pattern;
}

std::vector<Orbit> between(const std::vector<Orbit>& from, const std::vector<Orbit>& to, float part) {
    const auto geometric = [&](float a, float b) { return a * std::pow(b > 0 ? b / a : 1.0f, part); };
    std::vector<Orbit> orbits;
    for (size_t i = 0; i < from.size(); ++i)
        orbits.push_back({geometric(from[i].u, to[i].u), geometric(from[i].v, to[i].v), geometric(from[i].share, to[i].share),
                          std::lerp(from[i].level, to[i].level, part)});
    return orbits;
}

LobePattern tuned_pattern(int samples, float mx, float my, LobeTail tail) {
    const float aspect = mx / my, m = std::sqrt(mx * my);
    const std::span<const TunedPattern> family = nearest_family(samples, aspect, tail);
    const auto above = std::ranges::find_if(family, [&](const TunedPattern& entry) { return entry.m > m; });
    const TunedPattern &from = above == family.begin() ? *above : above[-1], &to = above == family.end() ? from : *above;
    const float part = from.m < to.m ? std::log(m / from.m) / std::log(to.m / from.m) : 0.0f;
    LobePattern pattern = unfolded(between(from.orbits, to.orbits, part), tail);
    if (aspect < 1)
        for (PatternSample& s : pattern) std::swap(s.u, s.v);
    return pattern;
}

bool is_tuned_better(int samples, float aspect) {
    if (samples > kMostSamples || std::max(aspect, 1 / aspect) > kWidestAspect) return false;
    return samples >= (aspect == 1 ? kFewestSamples : kFewestAnisotropic);
}

}  // namespace burnish
