#include <burnish/sampling/tuned_patterns.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

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

constexpr int kMostSamples = 12, kFewestSamples = 3, kFewestAnisotropic = 7;
constexpr float kWidestAspect = 2.0f;

}  // namespace

LobeTail lobe_tail(const RadiusOf& radius_of) {
    return radius_of(0.01f) > 2 * gaussian_radius(0.01f) ? LobeTail::long_tail : LobeTail::gaussian;
}

const std::vector<TunedPattern>& tuned_patterns() {
    static const std::vector<TunedPattern> table = {
#define BURNISH_TUNED_PATTERN(tail, samples, aspect, ...) {LobeTail::tail, samples, aspect, {__VA_ARGS__}},
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

LobePattern tuned_pattern(int samples, float aspect, LobeTail tail) {
    const TunedPattern* best = nullptr;
    for (const TunedPattern& entry : tuned_patterns())
        if (entry.tail == tail && (!best || mismatch(entry, samples, aspect) < mismatch(*best, samples, aspect))) best = &entry;
    LobePattern pattern = unfolded(best->orbits, tail);
    if (aspect < 1)
        for (PatternSample& s : pattern) std::swap(s.u, s.v);
    return pattern;
}

bool is_tuned_better(int samples, float aspect) {
    if (samples > kMostSamples || std::max(aspect, 1 / aspect) > kWidestAspect) return false;
    return samples >= (aspect == 1 ? kFewestSamples : kFewestAnisotropic);
}

}  // namespace burnish
