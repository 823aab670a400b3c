// Tuned patterns: few samples whose places, weights and filter widths were fitted to lights, not laid out by a rule.
//
// Every pattern mirrors into itself at both axes, so it is stored as orbits: one sample and its mirror images. The table,
// tuned_patterns.def, is written by tests/bench/tune_patterns.cpp, which fits a pattern per count and anisotropy for lobes with Gaussian
// tails (Beckmann, Kurt) and with long ones (GGX). What is best moves slowly with the roughness, as lights have details of some
// sizes more than of others: the same orbits are given at a few widths, and between them interpolated in log m.
#pragma once

#include <burnish/sampling/lobe_pattern.h>

#include <vector>

namespace burnish {

enum class LobeTail { gaussian, long_tail };

/// Which of the two a lobe is nearer to; see RadiusOf.
LobeTail lobe_tail(const RadiusOf& radius_of);

/// A sample at (u, v) >= 0 and its images at (+-u, +-v): one, two or four samples, as coordinates are zero or not.
struct Orbit {
    float u, v;   // normalised slopes
    float share;  // of the lobe's energy seen from above, of each sample; relative to the other orbits
    float level;  // MIP level, relative to a filter as wide as the disc of radius 1; EstimatorSettings' level_bias comes on top
};

struct TunedPattern {
    LobeTail tail;
    int samples;
    float aspect;  // max(mx, my) / min(mx, my); u lies along the wider axis. 1 is for isotropic lobes: u lies along the view
    float m;       // sqrt(mx my)
    std::vector<Orbit> orbits;
};

/// The whole table, ordered by tail, aspect, samples and m; those that differ in m alone have the same orbits, elsewhere.
const std::vector<TunedPattern>& tuned_patterns();

/// The samples of the orbits. Areas hold the levels, weights bring the shares back.
LobePattern unfolded(const std::vector<Orbit>& orbits, LobeTail tail);

/// `from` moved the `part` in [0, 1] of the way to `to`: levels linearly, all else by constant ratios.
std::vector<Orbit> between(const std::vector<Orbit>& from, const std::vector<Orbit>& to, float part);

/// The tuned pattern nearest in count, then in log mx/my, for lobes of these widths; narrower or wider ones than the table has take
/// its first or last. mx = my gets the isotropic pattern, and no other does.
LobePattern tuned_pattern(int samples, float mx, float my, LobeTail tail);

/// Whether the table measured better than equally spaced circles for this request (docs/measured.md).
bool is_tuned_better(int samples, float aspect);

}  // namespace burnish
