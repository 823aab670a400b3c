// burnish factor: a material under its light, or its BRDF, becomes a product of two to four small maps.
#include "command.h"
#include "progress_display.h"
#include "setting_options.h"

#include <burnish/job/make_factors.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <sstream>

namespace burnish::cli {
namespace {

using nlohmann::json;

struct Options {
    json values = json::object();
    std::string progress = "auto";
    bool as_json = false;
};

void print(const char* name, const FactorError& error) {
    std::printf("%-12s relative %.3f on average, %.3g at most; RMS %.4g, %.3g at most\n", name, error.average_relative,
                error.max_relative, error.rms, error.max_absolute);
}

void print(const FactorReport& report) {
    std::printf("%s: %s\n", report.stored.factors.parametrization->name.c_str(),
                report.stored.factors.parametrization->summary.c_str());
    print("error", report.error);
    if (report.picture_error) print("in 8 bits", *report.picture_error);
    if (report.display_psnr_db) std::printf("%-12s %.1f dB against reference\n", "display", *report.display_psnr_db);
    for (const auto& [stage, elapsed] : report.seconds) std::printf("%-12s %.2f s\n", stage.c_str(), elapsed);
    for (const std::string& file : report.files) std::printf("%s\n", file.c_str());
}

int run_factor(const Options& options) {
    const FactorJob job = factor_job_from_json(options.values, "burnish factor");
    const FactorReport report = [&] {
        ProgressDisplay display(options.progress);
        return make_factors(job, nullptr, display.progress());
    }();
    if (options.as_json)
        std::printf("%s\n", factor_report_to_json(report).dump(2).c_str());
    else
        print(report);
    return 0;
}

/// Adds options whose values are kept by the names of fields.
class FieldOptions {
public:
    FieldOptions(CLI::App& command, json& values) : m_command(command), m_values(values) {}

    template <class Value>
    CLI::Option* add(const std::string& flag, const std::string& field, const std::string& help, const std::string& type) {
        return m_command
            .add_option_function<Value>(
                flag, [this_values = &m_values, field](const Value& value) { (*this_values)[field] = value; }, help)
            ->type_name(type);
    }
    void add_choice(const std::string& field, std::span<const std::string_view> names, const std::string& help) {
        add<std::string>("--" + field, field, help, "NAME")
            ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
    }

private:
    CLI::App& m_command;
    json& m_values;
};

std::vector<std::string> parametrization_names() {
    std::vector<std::string> names;
    for (const Parametrization& parametrization : parametrizations()) names.push_back(parametrization.name);
    return names;
}

void add_outputs(FieldOptions& fields, CLI::App& command, json& values) {
    fields.add<std::string>("-o,--output", "output", "maps of half floats, an EXR with a part a map", "FILE")->required();
    fields.add<std::string>("--png", "png", "folder for the maps in 8 bits: a PNG a map, JSON and GLSL beside them", "DIR");
    fields.add<std::string>("--glsl", "glsl", "shader that shades from the maps of the EXR", "FILE");
    fields
        .add<std::vector<float>>("--prescale", "prescale",
                                 "8 bits: weights of the colour and of each map [those of the least error]", "W,W,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    fields.add<float>("--white", "white", "8 bits: the value that is clamped at, radiance or 1/sr [that of the least error]",
                      "VALUE");
    command.add_flag_function(
        "--no-alpha", [&values](std::int64_t) { values["alpha"] = false; }, "8 bits: leave alpha to others; less exact");
}

void add_maps(FieldOptions& fields, CLI::App& command, json& values) {
    constexpr std::string_view kSpheres[] = {"double_parabolic", "cube"};
    fields
        .add<std::string>("--parametrization", "parametrization", "what the maps are looked up by [nre, of BRDFs pqp]", "NAME")
        ->check(CLI::IsMember(parametrization_names()));
    fields.add_choice("method", kFactorMethods, "svd and normalised: of BRDFs over two maps, io and hd [homomorphic]");
    fields.add_choice("quality", kFactorQualities, "texels and samples [normal]");
    fields.add_choice("mapping", kSpheres, "of directions all around [double_parabolic]");
    fields.add<int>("--size", "size", "along a disc or face [preview 16, normal 32, high 64]", "TEXELS");
    fields.add<int>("--grid", "grid", "along the discs that directions of samples are taken from [10, 20, 26]", "TEXELS");
    fields.add<int>("--terms", "terms", "products that are summed, 0: by the parametrisation [0]", "0..4");
    fields.add_choice("measure", kFactorMeasures, "which error is made least [display, of BRDFs relative]");
    fields.add_choice("weight", kViewWeights,
                      "lighting: pairs of normal and view count the same, or as they are seen [projected]");
    fields.add<float>("--smoothness", "smoothness", "of the maps, where samples leave them open [0.02, of measured files 1]",
                      "0..");
    command.add_flag_function(
        "--no-polish", [&values](std::int64_t) { values["polish"] = false; }, "keep the first solution, which is less exact");
}

}  // namespace

Run add_factor(CLI::App& app) {
    auto* command = app.add_subcommand("factor", "Turns a material under its light, or its BRDF, into a product of small maps");
    auto options = std::make_shared<Options>();
    FieldOptions fields(*command, options->values);
    fields
        .add<std::string>("--material", "material", "a preset, merl:NAME, a file or a measured table; see burnish models",
                          "NAME")
        ->required();
    fields.add<std::string>("--env", "env", "light from all around; without it the BRDF is factored", "FILE");
    add_outputs(fields, *command, options->values);
    add_maps(fields, *command, options->values);
    for (const char* setting : {"estimator", "samples", "threads"}) add_setting_option(*command, options->values, setting);
    add_setting_options(*command, options->values, "lights");
    command->add_option("--progress", options->progress, "on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command->add_flag("--json", options->as_json, "print the report as JSON");
    command->footer("Example: burnish factor --material gold --env sky.hdr -o gold.exr --glsl gold.glsl");
    return [options] { return run_factor(*options); };
}

}  // namespace burnish::cli
