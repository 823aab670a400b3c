// Prints how well `fit_lobes` finds numbers that are known: tables of the published materials, and any measured files.
#include <burnish/base/parallel.h>
#include <burnish/fit/fit_lobes.h>
#include <burnish/fit/transfer_samples.h>
#include <burnish/material/albedo.h>
#include <core/fit/synthetic_table.h>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace {

using namespace burnish;
using burnish::testing::Faults;
using burnish::testing::KnownMaterial;

void print_lobe(const char* what, const LobeParameters& lobe) {
    std::printf("  %-6s %s ks %.4f m %.5f %.5f r0 %.4f ks.r0 %.4f alpha %.4f tint %.3f %.3f %.3f\n", what,
                lobe.side == Side::reflection ? "R" : "T", lobe.strength, lobe.mx, lobe.my, lobe.fresnel.eta.x,
                lobe.strength * (lobe.side == Side::reflection ? lobe.fresnel.eta.x : 1 - lobe.fresnel.eta.x),
                lobe.extra.empty() ? 0.0f : lobe.extra[0], lobe.tint.x, lobe.tint.y, lobe.tint.z);
}

/// Albedo of one side at 35 degrees.
float albedo(const Material& material, Side side) {
    float sum = side == Side::reflection ? material.kd.x : 0;
    for (const LobeParameters& lobe : material.lobes)
        if (lobe.side == side) sum += directional_albedo(lobe, burnish::testing::direction(35, 20)).x;
    return sum;
}

void print_known(const KnownMaterial& known, const Faults& faults, const FitSettings& settings) {
    const std::vector<BrdfSample> samples = burnish::testing::measure_grey(known.material, known.grid, faults);
    const FitResult result = fit_lobes(samples, false, settings, {});
    std::printf("%s, %zu samples: %zu lobes of %zu, L1 %.5f, %.2f s; kd %.4f of %.4f\n", known.name.c_str(), samples.size(),
                result.material.lobes.size(), known.material.lobes.size(), result.l1, result.seconds, result.material.kd.x,
                known.material.kd.x);
    for (const Side side : {Side::reflection, Side::transmission})
        std::printf("  albedo %.4f of %.4f\n", albedo(result.material, side), albedo(known.material, side));
    for (const LobeParameters& lobe : known.material.lobes) print_lobe("known", lobe);
    for (const LobeParameters& lobe : result.material.lobes) print_lobe("found", lobe);
    for (const std::string& note : result.notes) std::printf("  %s\n", note.c_str());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"How well fits find known numbers"};
    float step = 5;
    Faults faults;
    int lobes = 3;
    std::string only;
    app.add_option("--step", step, "degrees between outgoing directions");
    app.add_option("--noise", faults.ratio);
    app.add_option("--floor", faults.floor);
    app.add_option("--shadow", faults.shadow_deg);
    app.add_option("--max-lobes", lobes);
    app.add_option("--only", only);
    CLI11_PARSE(app, argc, argv);
    FitSettings settings;
    settings.model = ModelId::kurt;
    settings.max_lobes = lobes;
    for (const KnownMaterial& known : burnish::testing::published_materials(step))
        if (known.name.find(only) != std::string::npos) print_known(known, faults, settings);
}
