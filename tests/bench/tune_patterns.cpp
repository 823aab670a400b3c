// Fits the tuned patterns and prints their table: burnish_tune_patterns > core/burnish/sampling/tuned_patterns.def
//
// Errors of `regular` are taken at points on spheres under stress lights (a few small spots) and room lights (texture, windows and
// lamps), each relative to what the equally spaced pattern leaves there with the best border and level bias for that width and kind
// of light. Starts are rows of samples across the lobe, in every arrangement that suits its anisotropy, fitted as one pattern for
// all widths on few points; the best become families over the width, fitted on all. The same seed gives the same table, whatever
// the number of threads.
#include "pattern_family.h"

#include "core/room_light.h"
#include "core/scenes.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <numeric>
#include <set>

using namespace burnish;

namespace {

constexpr int kManyWays = 9;          // up to here a sample more or less in a row makes a different pattern
constexpr double kStartRadius = 1.4;  // of the Gaussian lobe that the rows fill, exp(-1.4^2) = 0.14 beyond
constexpr int kFirstIterations = 5, kIterations = 12;
constexpr size_t kFinalists = 2;

const char* name_of(LobeTail tail) { return tail == LobeTail::gaussian ? "gaussian" : "long_tail"; }

float lobe_radius(LobeTail tail, float xi) { return tail == LobeTail::gaussian ? gaussian_radius(xi) : std::sqrt(1 / xi - 1); }

/// Counts of the rows from the middle outwards (both sides alike) that put `n` samples into a disc, or {} if none do.
/// `rounding` decides between the two nearest counts of a row.
std::vector<int> row_counts(int n, int rows, double rounding) {
    const auto chord = [&](int j) { return std::sqrt(1 - std::pow((2 * j + (rows % 2 ? 0 : 1)) / double(rows), 2)); };
    const int sides = (rows + 1) / 2;
    double total = 0;
    for (int j = 0; j < sides; ++j) total += (j == 0 && rows % 2 ? 1 : 2) * chord(j);
    std::vector<int> counts(sides);
    int rest = n;
    for (int j = sides - 1; j > 0; --j) rest -= 2 * (counts[j] = static_cast<int>(n * chord(j) / total + rounding));
    counts[0] = rows % 2 ? rest : rest / 2;
    const bool possible = rest > 0 && (rows % 2 || rest % 2 == 0) && std::ranges::min(counts) > 0;
    return possible ? counts : std::vector<int>{};
}

/// Rows of samples along u, staggered where neighbours differ by one, as orbits of a lobe with this tail.
std::vector<Orbit> rows_of(const std::vector<int>& counts, int rows, int n, LobeTail tail, bool upright) {
    std::vector<Orbit> orbits;
    for (size_t j = 0; j < counts.size(); ++j) {
        const double y = (2 * j + (rows % 2 ? 0 : 1)) / double(rows), half = std::sqrt(1 - y * y);
        for (int k = counts[j] / 2; k < counts[j]; ++k) {
            const double x = half * (2 * k + 1 - counts[j]) / counts[j];
            const double w2 = kStartRadius * kStartRadius * (x * x + y * y);
            const double stretch =
                w2 > 0 ? lobe_radius(tail, static_cast<float>(std::exp(-w2))) / std::sqrt(w2) * kStartRadius : 0;
            const double wider = tail == LobeTail::gaussian ? 0 : w2 / 2 * std::numbers::log2e;
            Orbit orbit{static_cast<float>(x * stretch), static_cast<float>(y * stretch), static_cast<float>(std::exp(-w2)),
                        static_cast<float>(std::log2(kStartRadius / std::sqrt(n)) + wider)};
            if (upright) std::swap(orbit.u, orbit.v);
            orbits.push_back(orbit);
        }
    }
    return orbits;
}

std::vector<std::vector<Orbit>> starts(int n, float aspect, LobeTail tail) {
    std::set<std::pair<int, std::vector<int>>> arrangements;
    const double ideal = std::sqrt(n / aspect);
    for (int rows = 1; rows <= n; ++rows)
        for (const double rounding : n <= kManyWays ? std::vector<double>{-0.7, 0.3, 0.7} : std::vector<double>{0.5})
            if (std::abs(rows - ideal) < 1.2 + 0.25 * ideal)
                if (const std::vector<int> counts = row_counts(n, rows, rounding); !counts.empty())
                    arrangements.insert({rows, counts});
    std::vector<std::vector<Orbit>> list;
    for (const auto& [rows, counts] : arrangements) {
        list.push_back(rows_of(counts, rows, n, tail, false));
        if (aspect < 1.5) list.push_back(rows_of(counts, rows, n, tail, true));
    }
    return list;
}

/// The equally spaced pattern, its level bias changed by this much.
LobePattern rule(int n, float aspect, LobeTail tail, float border, float bias) {
    const auto radius_of = [&](float xi) { return lobe_radius(tail, xi); };
    LobePattern pattern = regular_pattern(PatternKind::automatic, n, aspect, 1, border, radius_of);
    for (PatternSample& s : pattern) s.area *= std::exp2(2 * bias);
    return pattern;
}

/// With many borders and level biases, or with the defaults alone.
std::vector<LobePattern> rules(int n, float aspect, LobeTail tail, bool defaults) {
    const float own = default_border(n, [&](float xi) { return lobe_radius(tail, xi); });
    if (defaults) return {rule(n, aspect, tail, own, 0)};
    std::vector<LobePattern> list;
    for (const float border : {0.02f, 0.04f, 0.07f, 0.1f, 0.15f, 0.2f, 0.25f, 0.3f, 0.4f})
        for (const float bias : {-0.3f, 0.0f, 0.3f, 0.6f}) list.push_back(rule(n, aspect, tail, border, bias));
    return list;
}

/// Every start is fitted as one pattern of all widths on few points; the best at every width on all points.
Family best_fit(int n, float aspect, LobeTail tail, const std::vector<float>& widths, const TrainingSets& few,
                const TrainingSets& all) {
    std::vector<Fit> fits;
    for (const std::vector<Orbit>& start : starts(n, aspect, tail))
        fits.push_back(fitted(Family({1}, {start}), tail, few, kFirstIterations));
    std::ranges::stable_sort(fits, {}, &Fit::cost);
    std::vector<Fit> finalists;
    for (size_t i = 0; i < std::min(fits.size(), kFinalists); ++i) {
        const Family spread(widths, std::vector(widths.size(), fits[i].family.orbits()[0]));
        finalists.push_back(fitted(spread, tail, all, kIterations));
    }
    return std::ranges::min(finalists, {}, &Fit::cost).family;
}

/// Prints the lines of the table.
void print(const Family& family, LobeTail tail, int n, float aspect) {
    for (size_t i = 0; i < family.widths().size(); ++i) {
        const std::vector<Orbit>& orbits = family.orbits()[i];
        double total = 0;
        for (const Orbit& o : orbits) total += o.share * (o.u > 0 ? 2 : 1) * (o.v > 0 ? 2 : 1);
        std::printf("BURNISH_TUNED_PATTERN(%s, %d, %g, %g", name_of(tail), n, aspect, family.widths()[i]);
        for (const Orbit& o : orbits) std::printf(", {%.4g, %.4g, %.4g, %.3g}", o.u, o.v, o.share / total, o.level);
        std::puts(")");
    }
    std::fflush(stdout);
}

/// Prints errors relative to the best equally spaced pattern's, for each kind of light: of all widths, and of each.
void report(std::FILE* file, const TrainingSets& sets, const PatternOf& pattern_of, const std::vector<float>& widths) {
    for (const TrainingSet& set : sets) {
        const std::vector<double> errors = set.errors(pattern_of);
        std::fprintf(file, " %.3f, by width", std::sqrt(std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0)));
        for (const float m : widths) std::fprintf(file, " %.3f", set.width_error(m, errors));
        std::fputs(&set == &sets.back() ? "\n" : "; ", file);
    }
    std::fflush(file);
}

/// What to fit, for isotropic lobes or for others.
struct Plan {
    std::vector<int> samples;
    std::vector<float> nodes, widths;
};

struct Options {
    Plan isotropic{
        {3, 4, 5, 7, 9, 12, 16, 19, 30}, {0.02f, 0.06f, 0.15f, 0.4f}, {0.02f, 0.035f, 0.06f, 0.1f, 0.15f, 0.25f, 0.4f}};
    Plan anisotropic{{3, 4, 5, 7, 9, 12, 16, 19, 30}, {0.03f, 0.08f, 0.2f}, {0.03f, 0.05f, 0.08f, 0.12f, 0.2f}};
    std::vector<float> aspects{1.0f, 1.3f};
    std::vector<std::string> tails{"gaussian", "long_tail"}, files;
    int lights = 32, points = 50;
    uint32_t seed = 1;
    bool check = false, defaults = false;
};

Options parsed(CLI::App& app, int argc, char** argv) {
    Options options;
    const auto add_list = [&](const std::string& name, auto& list, const std::string& what) {
        app.add_option(name, list, what)->delimiter(',')->capture_default_str();
    };
    const auto add_plan = [&](const std::string& prefix, Plan& plan, const std::string& lobes) {
        add_list(prefix + "samples", plan.samples, "counts, " + lobes);
        add_list(prefix + "nodes", plan.nodes, "widths m = sqrt(mx my) of the table's lines, " + lobes);
        add_list(prefix + "widths", plan.widths, "m of the lobes they are fitted to or checked on, " + lobes);
    };
    add_plan("--", options.isotropic, "isotropic lobes");
    add_plan("--anisotropic-", options.anisotropic, "other lobes");
    add_list("--aspects", options.aspects, "max(mx, my) / min(mx, my); 1 is the isotropic lobe");
    add_list("--tails", options.tails, "gaussian, long_tail");
    add_list("--lights-from", options.files, "environment files instead of lights made in code");
    app.add_option("--lights", options.lights, "number of stress lights, and of room lights")->capture_default_str();
    app.add_option("--points", options.points, "per light and width")->capture_default_str();
    app.add_option("--seed", options.seed, "of the first light")->capture_default_str();
    app.add_flag("--check", options.check, "instead print the errors of the table as compiled in");
    app.add_flag("--against-defaults", options.defaults,
                 "errors relative to the equally spaced pattern with the default border and level bias, not with the best");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error));
    }
    return options;
}

/// Lights of every kind: stress lights and room lights, or the files.
std::vector<std::vector<Environment>> light_kinds(const Options& options) {
    if (!options.files.empty()) return {lights_from(options.files)};
    return {made_lights(options.lights, options.seed, [](uint32_t seed) { return scenes::stress_light(seed); }),
            made_lights(options.lights, options.seed, [](uint32_t seed) { return scenes::room_light(seed); })};
}

/// Fits, or checks, the patterns of one tail and aspect.
void run(LobeTail tail, float aspect, const std::vector<std::vector<Environment>>& kinds, const Options& options) {
    const Plan& plan = aspect == 1 ? options.isotropic : options.anisotropic;
    TrainingSets few, all;
    for (const std::vector<Environment>& kind : kinds) {
        const std::span<const Environment> some(kind.data(), std::max<size_t>(kind.size() / 4, 1));
        if (!options.check) few.emplace_back(tail, aspect, plan.widths, some, options.points, options.seed);
        all.emplace_back(tail, aspect, plan.widths, kind, options.points, options.seed);
    }
    for (const int n : plan.samples) {
        const std::vector<LobePattern> references = rules(n, aspect, tail, options.defaults);
        for (TrainingSet& set : few) set.relate_to(references);
        for (TrainingSet& set : all) set.relate_to(references);
        std::FILE* file = options.check ? stdout : stderr;
        const auto title = [&] { std::fprintf(file, "%s %d, aspect %g:", name_of(tail), n, aspect); };
        if (options.check) {
            const float half_aspect = std::sqrt(aspect);
            title(),
                report(
                    file, all, [&](float m) { return tuned_pattern(n, m * half_aspect, m / half_aspect, tail); }, plan.widths);
        } else {
            const Family family = best_fit(n, aspect, tail, plan.nodes, few, all);
            print(family, tail, n, aspect);
            title(), report(
                         file, all, [&](float m) { return unfolded(family.at(m), tail); }, plan.widths);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Fits patterns of few samples to lights and prints their table");
    const Options options = parsed(app, argc, argv);
    const std::vector<std::vector<Environment>> kinds = light_kinds(options);
    if (!options.check)
        std::puts("// Written by burnish_tune_patterns: tail, samples, aspect, m, then the orbits {u, v, share, level}.");
    for (const std::string& tail : options.tails)
        for (const float aspect : options.aspects)
            run(tail == name_of(LobeTail::gaussian) ? LobeTail::gaussian : LobeTail::long_tail, aspect, kinds, options);
    return 0;
}
