// How well `fit_lobes` finds numbers that are known: tables of the published materials with the faults of measurements, several of each.
// Prints the number of lobes found, the worst relative error of every number over all tables, and the time. Fits measured files, too.
#include <burnish/fit/search/fit_lobes.h>
#include <burnish/fit/search/transfer_samples.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/model.h>
#include <core/fit/synthetic_table.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

namespace {

using namespace burnish;
using namespace burnish::testing;

/// Worst relative errors by name.
using Worst = std::map<std::string, double>;

void compare(Worst& worst, const std::string& name, double found, double known) {
    worst[name] = std::max(worst[name], std::abs(found / known - 1));
}

/// What r0 and strength amount to facing the surface: ks r0, or kt (1 - r0).
float facing(const LobeParameters& lobe) {
    const float r0 = lobe.fresnel.eta.x;
    return lobe.strength * (lobe.side == Side::reflection ? r0 : 1 - r0);
}

float albedo(const Material& material, Side side, float theta_deg, float phi_deg) {
    float sum = side == Side::reflection ? material.kd.x : 0;
    for (const LobeParameters& lobe : material.lobes)
        if (lobe.side == side) sum += directional_albedo(lobe, direction(theta_deg, phi_deg)).x;
    return sum;
}

/// Over the incident directions that were measured, as the source's tables have it.
void compare_albedo(Worst& worst, const KnownMaterial& known, const Material& found) {
    for (const Side side : {Side::reflection, Side::transmission}) {
        float expected = 0, mean = 0;
        for (const float theta : known.grid.theta_i_deg)
            for (const float phi : {known.grid.phi_i_deg.front(), known.grid.phi_i_deg.back()}) {
                expected += albedo(known.material, side, theta, phi);
                mean += albedo(found, side, theta, phi);
            }
        if (expected > 0) compare(worst, "albedo", mean, expected);
    }
}

void compare_lobe(Worst& worst, const LobeParameters& known, const LobeParameters& found) {
    compare(worst, "m", found.mx, known.mx);
    compare(worst, "m", found.my, known.my);
    compare(worst, "ks r0", facing(found), facing(known));
    compare(worst, "alpha", found.extra[0], known.extra[0]);
    if (known.side == Side::transmission) return;  // where only the product counts
    compare(worst, "r0", found.fresnel.eta.x, known.fresnel.eta.x);
    compare(worst, "ks", found.strength, known.strength);
}

/// Narrow lobes first, reflection first.
std::vector<LobeParameters> sorted(const Material& material) {
    std::vector<LobeParameters> lobes = material.lobes;
    std::ranges::sort(lobes, {}, [](const LobeParameters& lobe) { return std::pair(lobe.side, lobe.my); });
    return lobes;
}

struct Settings {
    Faults faults;
    FitSettings fit;
    int tables = 5;
    bool verbose = false;
};

void print_lobes(const Material& material) {
    std::printf("  kd %.4f\n", material.kd.x);
    for (const LobeParameters& lobe : sorted(material))
        std::printf("  ks %.4f mx %.5f my %.5f r0 %.4f alpha %.4f\n", lobe.strength, lobe.mx, lobe.my, lobe.fresnel.eta.x,
                    lobe.extra.empty() ? 0 : lobe.extra[0]);
}

void print_row(const KnownMaterial& known, const Settings& settings) {
    Worst worst;
    int right = 0;
    double l1 = 0;
    std::vector<double> seconds;
    for (int table = 0; table < settings.tables; ++table) {
        const FitResult fit =
            fit_lobes(measure_grey(known.material, known.grid, settings.faults, static_cast<unsigned>(table + 1)), false,
                      settings.fit, {});
        seconds.push_back(fit.seconds);
        l1 = std::max(l1, fit.l1);
        if (settings.verbose) {
            print_lobes(fit.material);
            for (const std::string& note : fit.notes) std::printf("  %s\n", note.c_str());
        }
        compare_albedo(worst, known, fit.material);
        if (fit.material.lobes.size() != known.material.lobes.size()) continue;
        ++right;
        compare(worst, "kd", fit.material.kd.x, known.material.kd.x);
        const std::vector<LobeParameters> found = sorted(fit.material), expected = sorted(known.material);
        for (size_t n = 0; n < found.size(); ++n) compare_lobe(worst, expected[n], found[n]);
    }
    std::ranges::sort(seconds);
    std::printf("| %s | %d of %d | %.4f |", known.name.c_str(), right, settings.tables, l1);
    for (const char* name : {"m", "ks r0", "alpha", "kd", "albedo", "ks", "r0"}) std::printf(" %.2f |", 100 * worst[name]);
    std::printf(" %.1f | %.1f |\n", seconds[seconds.size() / 2], seconds.back());
    std::fflush(stdout);
}

/// Share of the light that the fit misses for each incident direction, highlights (half vectors within `kPeak_deg` of the normal)
/// apart: a coarse table has one reading of them.
void print_angles(const std::vector<BrdfSample>& pairs, const Material& material) {
    constexpr float kPeak_deg = 2;
    const TransferSamples samples = transfer_samples(pairs, Side::reflection);
    const std::vector<Color3f> model = model_transfer(material, samples, Side::reflection);
    std::map<int, std::array<double, 2>> sums;
    for (size_t j = 0; j < samples.size(); ++j) {
        if ((samples.wo[j] + samples.wi[j]).normalized().z > std::cos(kPeak_deg * kPi / 180)) continue;
        const Vec3f& incident = samples.incident_directions[static_cast<size_t>(samples.incident[j])];
        auto& [missed, light] = sums[static_cast<int>(std::lround(std::acos(incident.z) * 180 / kPi))];
        for (int c = 0; c < 3; ++c) missed += samples.weight[j] * std::abs(samples.p[j][c] - model[j][c]);
        for (int c = 0; c < 3; ++c) light += samples.weight[j] * samples.p[j][c];
    }
    for (const auto& [theta, sum] : sums) std::printf("  %d deg: %.0f %%\n", theta, 100 * sum[0] / sum[1]);
}

void print_file(const std::string& file, const FitSettings& settings) {
    const std::shared_ptr<const MeasuredBrdf> measured = read_measured(file);
    const FitResult fit = fit_lobes(*measured, settings, {});
    std::printf("%s: %s\n  L1 %.5f, %d numbers, %.1f s\n", file.c_str(), material_to_json(fit.material).dump().c_str(), fit.l1,
                fit.parameters, fit.seconds);
    for (const std::string& note : fit.notes) std::printf("  %s\n", note.c_str());
    print_angles(measured->samples(), fit.material);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"How well fits find known numbers"};
    Settings settings;
    float step = 5;
    std::string only, model = "kurt";
    std::vector<std::string> files;
    app.add_option("files", files, "measured files to fit instead");
    app.add_option("--model", model, "of the files; best: the best of three");
    app.add_option("--step", step, "degrees between outgoing directions");
    app.add_option("--noise", settings.faults.ratio, "in ratio");
    app.add_option("--floor", settings.faults.floor, "of the sensor, in f");
    app.add_option("--shadow", settings.faults.shadow_deg, "degrees about the incident direction without data");
    app.add_option("--tables", settings.tables, "of each material");
    app.add_option("--max-lobes", settings.fit.max_lobes);
    app.add_option("--only", only, "materials whose name has this in it");
    app.add_flag("--verbose", settings.verbose);
    CLI11_PARSE(app, argc, argv);
    if (model != "best") settings.fit.model = model_by_name(model);
    for (const std::string& file : files) print_file(file, settings.fit);
    if (!files.empty()) return 0;
    std::printf(
        "| material | lobes right | L1 | m %% | ks r0 %% | alpha %% | kd %% | albedo %% | ks %% | r0 %% | median s | worst s "
        "|\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const KnownMaterial& known : published_materials(step))
        if (known.name.find(only) != std::string::npos) print_row(known, settings);
}
