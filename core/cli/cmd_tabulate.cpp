// burnish tabulate: a material as a measured table, for other programs and for trying fits on what is known.
#include "command.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/material/library.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/gonio_file.h>
#include <burnish/material/measured/merl_table.h>

#include <algorithm>
#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string material, output, progress = "auto";
    float step_deg = 5;
    int threads = 0;
};

bool is_anisotropic(const Material& material) { return std::ranges::any_of(material.lobes, &LobeParameters::is_anisotropic); }

bool transmits(const Material& material) {
    return std::ranges::any_of(material.lobes, [](const LobeParameters& lobe) { return lobe.side == Side::transmission; });
}

Vec3f direction_deg(float theta_deg, float phi_deg) {
    const float theta = theta_deg * kPi / 180, phi = phi_deg * kPi / 180;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Light from every ten degrees, seen from every `step_deg`; behind the surface only where something comes through.
std::vector<BrdfSample> gonio_pairs(const Material& material, float step_deg) {
    constexpr float kIncidentStep_deg = 10, kSteepest_deg = 80, kLowest_deg = 88;
    const MaterialBrdf f(material);
    const bool turns = is_anisotropic(material), through = transmits(material);
    std::vector<BrdfSample> pairs;
    for (float theta_i = 0; theta_i <= kSteepest_deg; theta_i += kIncidentStep_deg)
        for (float phi_i = 0; phi_i < (turns ? 180.0f : 1.0f); phi_i += 15)
            for (float theta_o = 0; theta_o <= (through ? 180.0f : kLowest_deg); theta_o += step_deg)
                for (float phi_o = 0; phi_o < (turns ? 360.0f : 180.5f); phi_o += step_deg) {
                    if (std::abs(theta_o - 90) < 90 - kLowest_deg) continue;
                    const Vec3f light = direction_deg(theta_i, phi_i), out = direction_deg(theta_o, phi_o);
                    // What comes through is seen from above, with the light below: a thin sheet is the same both ways.
                    const BrdfSample pair =
                        out.z > 0 ? BrdfSample{out, light, f(out, light)} : BrdfSample{light, out, f(light, out)};
                    pairs.push_back(pair);
                }
    return pairs;
}

/// A MERL table has neither a tangent nor a back.
void refuse_what_merl_cannot_hold(const Material& material) {
    const char* what = is_anisotropic(material) ? "is anisotropic" : transmits(material) ? "lets light through" : nullptr;
    if (what)
        throw Error(ErrorCode::bad_argument,
                    material.name + ": " + what + ", which a MERL table cannot hold; give the output the extension .gonio");
}

int tabulate(const Options& options) {
    const ThreadLimit limit(options.threads);
    const Material material = find_material(options.material);
    if (options.output.ends_with(".gonio")) {
        write_gonio(gonio_pairs(material, options.step_deg), !is_anisotropic(material), options.output);
        return 0;
    }
    refuse_what_merl_cannot_hold(material);
    ProgressDisplay display(options.progress);
    MerlTable(MaterialBrdf(material), display.progress()).write(options.output);
    return 0;
}

}  // namespace

Run add_tabulate(CLI::App& app) {
    auto* command = app.add_subcommand("tabulate", "Writes a material as a table of values, as if it had been measured");
    auto options = std::make_shared<Options>();
    command->add_option("MATERIAL", options->material, "preset, merl:NAME, or file")->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "MERL table of 35 MB, for isotropic materials without transmission; or FILE.gonio, text with a line a pair")
        ->required()
        ->type_name("FILE");
    command->add_option("--step", options->step_deg, "between the outgoing directions of a .gonio, degrees [5]")
        ->check(CLI::Range(1.0f, 30.0f))
        ->type_name("DEG");
    command->add_option("--threads", options->threads, "[all cores]")->check(CLI::Range(0, 1024))->type_name("N");
    command->add_option("--progress", options->progress, "on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command->footer("Example: burnish tabulate gold -o gold.binary");
    return [options] { return tabulate(*options); };
}

}  // namespace burnish::cli
