// Fits the tuned patterns and prints their table: burnish_tune_patterns > core/burnish/sampling/tuned_patterns.def
//
// Least squares: the residuals are the errors of `regular` at points on spheres under stress lights, for all roughnesses at
// once, each relative to what the equally spaced pattern leaves there with the best border and level bias for it. The unknowns are places, shares and levels of a
// pattern's orbits. Starts are rows of samples across the lobe, in every arrangement that suits its anisotropy; all are
// fitted on few points, the best on all. The same seed gives the same table, whatever the number of threads.
#include "training_set.h"

#include <ceres/ceres.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <numeric>
#include <set>

using namespace burnish;

namespace {

constexpr int kManyWays = 9;          // up to here a sample more or less in a row makes a different pattern
constexpr double kStartRadius = 1.4;  // of the Gaussian lobe that the rows fill, exp(-1.4^2) = 0.14 beyond

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

/// The unknowns of a pattern: logarithms of what must stay positive, and levels.
class Unknowns {
public:
    explicit Unknowns(const std::vector<Orbit>& start) : m_start(start) {}

    std::vector<double> values() const {
        std::vector<double> x;
        for (const Orbit& orbit : m_start) {
            if (orbit.u > 0) x.push_back(std::log(orbit.u));
            if (orbit.v > 0) x.push_back(std::log(orbit.v));
            x.push_back(std::log(orbit.share)), x.push_back(orbit.level);
        }
        return x;
    }

    std::vector<Orbit> orbits(const double* x) const {
        std::vector<Orbit> orbits = m_start;
        for (Orbit& orbit : orbits) {
            if (orbit.u > 0) orbit.u = static_cast<float>(std::exp(*x++));
            if (orbit.v > 0) orbit.v = static_cast<float>(std::exp(*x++));
            orbit.share = static_cast<float>(std::exp(*x++)), orbit.level = static_cast<float>(*x++);
        }
        return orbits;
    }

private:
    std::vector<Orbit> m_start;
};

/// Errors of a pattern and their differences with its unknowns.
class PatternErrors : public ceres::CostFunction {
public:
    PatternErrors(const Unknowns& unknowns, LobeTail tail, const TrainingSet& training)
        : m_unknowns(unknowns), m_tail(tail), m_training(training) {
        set_num_residuals(static_cast<int>(training.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns.values().size()));
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        const int count = parameter_block_sizes()[0];
        std::vector<double> x(parameters[0], parameters[0] + count);
        const std::vector<double> here = errors(x);
        std::ranges::copy(here, residuals);
        if (!jacobians || !jacobians[0]) return true;
        for (int k = 0; k < count; ++k) {
            x[k] += kStep;
            const std::vector<double> there = errors(x);
            x[k] -= kStep;
            for (size_t i = 0; i < here.size(); ++i) jacobians[0][i * count + k] = (there[i] - here[i]) / kStep;
        }
        return true;
    }

private:
    static constexpr double kStep = 0.02;  // wide enough to see past the kinks of trilinear lookups

    std::vector<double> errors(const std::vector<double>& x) const {
        return m_training.errors(unfolded(m_unknowns.orbits(x.data()), m_tail));
    }

    const Unknowns& m_unknowns;
    LobeTail m_tail;
    const TrainingSet& m_training;
};

/// Mean square error relative to the best equally spaced pattern's, and the pattern that has it.
struct Fit {
    double cost;
    std::vector<Orbit> orbits;
};

Fit fitted(const std::vector<Orbit>& start, LobeTail tail, const TrainingSet& training, int iterations) {
    const Unknowns unknowns(start);
    std::vector<double> x = unknowns.values();
    ceres::Problem problem;
    problem.AddResidualBlock(new PatternErrors(unknowns, tail, training), nullptr, x.data());
    ceres::Solver::Options options;
    options.max_num_iterations = iterations, options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.function_tolerance = 1e-4, options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return {2 * summary.final_cost, unknowns.orbits(x.data())};
}

/// The equally spaced pattern at many borders and level biases (as areas, relative to the default bias).
std::vector<LobePattern> rules(int n, float aspect, LobeTail tail) {
    std::vector<LobePattern> list;
    for (const float border : {0.02f, 0.04f, 0.07f, 0.1f, 0.15f, 0.2f, 0.25f, 0.3f, 0.4f})
        for (const float bias : {-0.3f, 0.0f, 0.3f, 0.6f}) {
            const auto radius_of = [&](float xi) { return lobe_radius(tail, xi); };
            LobePattern pattern = regular_pattern(PatternKind::automatic, n, aspect, border, radius_of);
            for (PatternSample& s : pattern) s.area *= std::exp2(2 * bias);
            list.push_back(std::move(pattern));
        }
    return list;
}

std::vector<Orbit> best_fit(int n, float aspect, LobeTail tail, const TrainingSet& few, const TrainingSet& all) {
    Fit best{1e30, {}};
    for (const std::vector<Orbit>& start : starts(n, aspect, tail)) {
        Fit fit = fitted(start, tail, few, 5);
        if (fit.cost < best.cost) best = std::move(fit);
    }
    return fitted(best.orbits, tail, all, 15).orbits;
}

/// Prints the line of the table, and returns the pattern.
LobePattern print(const std::vector<Orbit>& orbits, LobeTail tail, int n, float aspect) {
    double total = 0;
    for (const Orbit& o : orbits) total += o.share * (o.u > 0 ? 2 : 1) * (o.v > 0 ? 2 : 1);
    std::printf("BURNISH_TUNED_PATTERN(%s, %d, %g", tail == LobeTail::gaussian ? "gaussian" : "long_tail", n, aspect);
    for (const Orbit& o : orbits) std::printf(", {%.4g, %.4g, %.4g, %.3g}", o.u, o.v, o.share / total, o.level);
    std::puts(")");
    std::fflush(stdout);
    return unfolded(orbits, tail);
}

/// Prints a pattern's error relative to the best equally spaced pattern's: of all widths, and of each.
void report(std::FILE* file, const TrainingSet& set, const LobePattern& pattern, const std::vector<float>& mx) {
    const std::vector<double> errors = set.errors(pattern);
    std::fprintf(file, " %.3f, by width", std::sqrt(std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0)));
    for (const float width : mx) std::fprintf(file, " %.3f", set.width_error(width, errors));
    std::fputs("\n", file);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> samples{3, 4, 5, 7, 9, 12, 16, 19, 30};
    std::vector<float> aspects{1.0f, 1.3f}, widths{0.02f, 0.05f, 0.1f, 0.2f, 0.4f}, anisotropic_widths{0.03f, 0.08f, 0.2f};
    std::vector<std::string> tails{"gaussian", "long_tail"};
    int lights = 16, points = 125;
    uint32_t seed = 1;
    bool check = false;
    std::vector<std::string> files;
    CLI::App app("Fits patterns of few samples to stress lights and prints their table");
    app.add_option("--samples", samples, "counts")->delimiter(',')->capture_default_str();
    app.add_option("--aspects", aspects, "max(mx, my) / min(mx, my); 1 is the isotropic lobe")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--widths", widths, "slope widths m fitted together, isotropic lobe")->delimiter(',')->capture_default_str();
    app.add_option("--anisotropic-widths", anisotropic_widths, "the same of other lobes, m = sqrt(mx my)")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--tails", tails, "gaussian, long_tail")->delimiter(',')->capture_default_str();
    app.add_option("--lights", lights, "number of stress lights")->capture_default_str();
    app.add_option("--points", points, "per light and width")->capture_default_str();
    app.add_option("--lights-from", files, "environment files instead of stress lights")->delimiter(',');
    app.add_flag("--check", check, "instead print the errors of the table as compiled in, relative to the equally spaced");
    app.add_option("--seed", seed, "of the first light")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    const std::vector<Environment> light_list = training_lights(lights, seed, files);
    const std::span<const Environment> some(light_list.data(), std::max<size_t>(light_list.size() / 4, 1));
    if (!check) std::puts("// Written by burnish_tune_patterns: tail, samples, aspect, then the orbits {u, v, share, level}.");
    for (const std::string& name : tails)
        for (const float aspect : aspects) {
            const LobeTail tail = name == "gaussian" ? LobeTail::gaussian : LobeTail::long_tail;
            std::vector<float> together = aspect == 1 ? widths : anisotropic_widths;
            TrainingSet all(tail, aspect, together, light_list, points, seed);
            TrainingSet few(tail, aspect, together, some, points, seed);
            for (float& m : together) m = std::min(m * std::sqrt(aspect), 1.0f);
            for (const int n : samples) {
                const std::vector<LobePattern> references = rules(n, aspect, tail);
                few.relate_to(references), all.relate_to(references);
                const LobePattern pattern =
                    check ? tuned_pattern(n, aspect, tail) : print(best_fit(n, aspect, tail, few, all), tail, n, aspect);
                std::fprintf(check ? stdout : stderr, "%s %d, aspect %g:", name.c_str(), n, aspect);
                report(check ? stdout : stderr, all, pattern, together);
            }
        }
    return 0;
}
