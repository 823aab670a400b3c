// burnish fit: a measured table becomes a material of a few numbers.
#include "command.h"
#include "external_command.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/fit/fit.h>
#include <burnish/material/library.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/model.h>
#include <burnish/output/exr_writer.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string table, output, report, plots, progress = "auto";
    FitSettings settings;
    int threads = 0;
    bool as_json = false;
};

double number(const std::string& text, const std::string& flag, const std::string& whole) {
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size())
        throw CLI::ValidationError(flag, "expected a number, found '" + text + "' in '" + whole + "'");
    return value;
}

/// "NAME=VALUE" or, with `range`, "NAME=MIN:MAX".
void add_bound(ParameterBounds& bounds, const std::string& text, bool range) {
    const std::string flag = range ? "--bound" : "--fix";
    const size_t equals = text.find('='), colon = text.find(':');
    if (equals == std::string::npos || (range && (colon == std::string::npos || colon < equals)))
        throw CLI::ValidationError(flag,
                                   std::string("expected NAME=") + (range ? "MIN:MAX" : "VALUE") + ", found '" + text + "'");
    const double low = number(text.substr(equals + 1, range ? colon - equals - 1 : std::string::npos), flag, text);
    const double high = range ? number(text.substr(colon + 1), flag, text) : low;
    if (low > high) throw CLI::ValidationError(flag, "the smaller number comes first, found '" + text + "'");
    bounds[text.substr(0, equals)] = {low, high};
}

void print(const FitComparison& comparison) {
    std::printf("%-18s %5s %8s %12s %10s %8s\n", "model", "lobes", "numbers", "L2 error", "L1 error", "seconds");
    for (const FitResult& fit : comparison.tried) {
        const auto& lobes = fit.material.lobes;
        const std::string model = lobes.empty() ? "diffuse" : std::string(model_info(lobes.front().model).name);
        char l2[32] = "-";
        if (fit.normalised_l2) std::snprintf(l2, sizeof l2, "%.3g", *fit.normalised_l2);
        std::printf("%-18s %5zu %8d %12s %10.3g %8.2f%s\n", model.c_str(), lobes.size(), fit.parameters, l2, fit.l1,
                    fit.seconds, &fit == &comparison.best() ? "  <- taken" : "");
    }
    for (const std::string& note : comparison.best().notes) std::printf("note: %s\n", note.c_str());
}

/// The report's file: what the user named, else one in the folder of the plots.
std::string report_file(const Options& options) {
    if (!options.report.empty() || options.plots.empty()) return options.report;
    return (std::filesystem::path(options.plots) / "report.json").string();
}

int draw(const Options& options) {
    std::string words[] = {"fit-plots", report_file(options), "-o", options.plots};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    return run_external(arguments, {});
}

int run_fit(const Options& options) {
    const ThreadLimit limit(options.threads);
    const std::shared_ptr<const MeasuredBrdf> data = read_measured(options.table);
    FitComparison comparison;
    {
        ProgressDisplay display(options.progress);
        comparison = fit_material(*data, options.settings, display.progress());
    }
    write_text(options.output, material_to_json(comparison.best().material).dump(2) + "\n");
    const nlohmann::json report = fit_report(*data, comparison);
    if (const std::string file = report_file(options); !file.empty()) {
        if (!options.plots.empty()) std::filesystem::create_directories(options.plots);
        write_text(file, report.dump() + "\n");
    }
    if (options.as_json)
        std::printf("%s\n", report.dump(2).c_str());
    else
        print(comparison);
    std::fflush(stdout);
    return options.plots.empty() ? 0 : draw(options);
}

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    for (const ModelInfo& model : models())
        if (model_by_name(model.name) != ModelId::table) names.emplace_back(model.name);
    return names;
}

}  // namespace

Run add_fit(CLI::App& app) {
    auto* command = app.add_subcommand("fit", "Fits a material of a few numbers to a measured table");
    auto options = std::make_shared<Options>();
    FitSettings& settings = options->settings;
    command->add_option("TABLE", options->table, "MERL .binary, Cornell .brdf, ALTA, or burnish's own gonio text")->required();
    command->add_option("-o,--output", options->output, "the material, JSON")->required()->type_name("FILE");
    command
        ->add_option_function<std::string>(
            "--model", [&settings](const std::string& name) { settings.model = model_by_name(name); },
            "[what describes the data best with the fewest numbers]")
        ->check(CLI::IsMember(model_names()))
        ->type_name("NAME");
    command->add_option("--lobes", settings.max_lobes, "at most, on each side; fewer where more do not pay [3]")
        ->check(CLI::Range(1, 3))
        ->type_name("N");
    command->add_flag("--all-lobes", settings.fixed_lobes, "as many lobes as --lobes says, whether they pay or not");
    const auto each = [&](const char* flag, const char* help, const char* type, bool range) {
        command
            ->add_option_function<std::vector<std::string>>(
                flag,
                [&settings, range](const std::vector<std::string>& items) {
                    for (const std::string& item : items) add_bound(settings.bounds, item, range);
                },
                help)
            ->type_name(type)
            ->allow_extra_args(false);
    };
    each("--bound", "keeps a parameter between two numbers; 2.NAME of the second lobe alone; repeatable", "NAME=MIN:MAX", true);
    each("--fix", "gives a parameter its value; repeatable", "NAME=VALUE", false);
    command->add_option("--report", options->report, "errors, residuals by angle, and curves of data and fit, JSON")
        ->type_name("FILE");
    command->add_option("--plots", options->plots, "folder for pictures: slices, lobes and balls of data and fit")
        ->type_name("DIR");
    command->add_option("--threads", options->threads, "[all cores]")->check(CLI::Range(0, 1024))->type_name("N");
    command->add_option("--progress", options->progress, "on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command->add_flag("--json", options->as_json, "print the report as JSON");
    command->footer("Example: burnish fit brass.binary -o brass.json --plots brass");
    return [options] { return run_fit(*options); };
}

}  // namespace burnish::cli
