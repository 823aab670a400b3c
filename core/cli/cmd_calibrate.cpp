// burnish calibrate: measures what burnish costs on this machine, for plans that are to keep within a time.
#include "command.h"
#include "progress_display.h"

#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>
#include <burnish/plan/machine_costs.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <optional>

namespace burnish::cli {
namespace {

struct Options {
    std::string output, progress = "auto";
    bool is_dry_run = false, as_json = false;
};

void print_table(const MachineCosts& costs) {
    std::printf("%s, %d cores; nanoseconds by the clock\n\n", costs.machine.c_str(), costs.cores);
    for (const CostField& field : cost_fields())
        std::printf("%-18s %10.4g  %s\n", std::string(field.name).c_str(), 1e9 * (costs.*field.value),
                    std::string(field.meaning).c_str());
    std::printf("\nOne sample of a model, one core:");
    for (const auto& [model, seconds] : costs.evaluation) std::printf(" %s %.3g", model.c_str(), 1e9 * seconds);
    std::printf("\n");
}

/// Where the user's plans look for it, unless another file is asked for.
std::string target_of(const Options& options) {
    const std::string file = options.output.empty() ? costs_file().string() : options.output;
    if (file.empty())
        throw Error(ErrorCode::bad_argument,
                    "there is no home folder to keep the calibration in; name a file with -o, and set "
                    "BURNISH_COSTS to it");
    return file;
}

MachineCosts measured(const std::string& progress) {
    ProgressDisplay display(progress);
    return measure_costs(display.progress());
}

int calibrate(const Options& options) {
    std::optional<AtomicFile> target;  // before anything is measured: where it cannot be written, nothing is
    if (!options.is_dry_run) target.emplace(target_of(options));
    const MachineCosts costs = measured(options.progress);
    const std::string text = costs_to_json(costs).dump(2) + "\n";
    if (target) {
        std::fwrite(text.data(), 1, text.size(), target->handle());
        target->commit();
    }
    if (options.as_json)
        std::printf("%s", text.c_str());
    else
        print_table(costs);
    if (target && !options.as_json) std::printf("\nWritten to %s\n", target_of(options).c_str());
    return 0;
}

}  // namespace

Run add_calibrate(CLI::App& app) {
    auto* command = app.add_subcommand("calibrate", "Measures what shading costs on this machine, for --psnr and --time");
    auto options = std::make_shared<Options>();
    command
        ->add_option("-o,--output", options->output,
                     "where to [$BURNISH_COSTS, else burnish/costs.json in the cache folder], which is where plans look for it")
        ->type_name("FILE");
    command->add_flag("--dry-run", options->is_dry_run, "print only");
    command->add_flag("--json", options->as_json, "print as JSON, as the file has it");
    command->add_option("--progress", options->progress, "on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command->footer(
        "Plans choose the cheapest way that is exact enough, so they ask what each way costs. Without a calibration they take "
        "the "
        "costs of a\ntypical machine with two cores. Takes some seconds, on a machine that is doing nothing else. Machines of "
        "one farm "
        "should share one file\n(BURNISH_COSTS): frames of one shot then have the same plan everywhere.");
    return [options] { return calibrate(*options); };
}

}  // namespace burnish::cli
