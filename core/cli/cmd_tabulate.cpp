// burnish tabulate: a material as a measured table, for other programs and for trying fits on what is known.
#include "command.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/material/library.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/merl_table.h>

#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string material, output, progress = "auto";
    int threads = 0;
};

/// A MERL table has neither a tangent nor a back.
void refuse_what_it_cannot_hold(const Material& material) {
    const auto fails = [&](const char* what) {
        throw Error(ErrorCode::bad_argument,
                    material.name + ": " + what + " and a MERL table cannot hold that; name another material");
    };
    for (const LobeParameters& lobe : material.lobes) {
        if (lobe.is_anisotropic()) fails("is anisotropic,");
        if (lobe.side == Side::transmission) fails("lets light through,");
    }
}

int tabulate(const Options& options) {
    const ThreadLimit limit(options.threads);
    const Material material = find_material(options.material);
    refuse_what_it_cannot_hold(material);
    ProgressDisplay display(options.progress);
    MerlTable(MaterialBrdf(material), display.progress()).write(options.output);
    return 0;
}

}  // namespace

Run add_tabulate(CLI::App& app) {
    auto* command = app.add_subcommand("tabulate", "Writes a material as a MERL table");
    auto options = std::make_shared<Options>();
    command->add_option("MATERIAL", options->material, "preset, merl:NAME, or file; isotropic, without transmission")
        ->required();
    command->add_option("-o,--output", options->output, "the table, 35 MB")->required()->type_name("FILE");
    command->add_option("--threads", options->threads, "[all cores]")->check(CLI::Range(0, 1024))->type_name("N");
    command->add_option("--progress", options->progress, "on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command->footer("Example: burnish tabulate gold -o gold.binary");
    return [options] { return tabulate(*options); };
}

}  // namespace burnish::cli
