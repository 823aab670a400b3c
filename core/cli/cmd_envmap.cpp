// burnish envmap: describes an environment map, or writes it in another layout.
#include "command.h"
#include "setting_options.h"

#include <burnish/job/color_flow.h>
#include <burnish/job/look.h>
#include <burnish/job/settings.h>
#include <burnish/output/envmap_writer.h>

#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string output, layout = "latlong";
    int size = 0;
    nlohmann::json values = nlohmann::json::object();
    bool as_json = false;
};

void print_json(const Environment& light) {
    const nlohmann::json out = {{"face_size", light.face_size()},
                                {"levels", light.pyramid().level_count()},
                                {"notes", light.notes()},
                                {"warnings", light.warnings()}};
    std::printf("%s\n", out.dump(2).c_str());
}

void print_text(const Environment& light) {
    for (const std::string& note : light.notes()) std::printf("%s\n", note.c_str());
    for (const std::string& warning : light.warnings()) std::fprintf(stderr, "burnish: warning: %s\n", warning.c_str());
}

int envmap(const Options& options) {
    Job job;
    if (!options.output.empty()) job.light.suns = Suns::keep;  // unless the settings say otherwise
    set_settings(job, options.values, "");
    const auto light = load_light(job, ColorFlow(job), Renderer::unknown);
    if (!options.output.empty()) {
        const EnvmapLayout layout = options.layout == "cube" ? EnvmapLayout::cube : EnvmapLayout::latlong;
        const int natural = light->face_size() * (layout == EnvmapLayout::cube ? 1 : 4);
        const int size = options.size > 0 ? options.size : natural;
        write_envmap(options.output, envmap_picture(*light, job.light.up, layout, size), layout);
    }
    if (options.as_json)
        print_json(*light);
    else
        print_text(*light);
    return 0;
}

}  // namespace

Run add_envmap(CLI::App& app) {
    auto* command = app.add_subcommand("envmap", "Describes an environment map, or writes it in another layout");
    auto options = std::make_shared<Options>();
    command
        ->add_option_function<std::string>(
            "IN", [options](const std::string& file) { options->values["env"] = file; }, "environment map, .hdr or .exr")
        ->required();
    add_setting_options(*command, options->values, "lights");
    command->add_option("-o,--output", options->output, "EXR to write")->type_name("FILE");
    command->add_option("--layout", options->layout, "of the EXR: latlong or cube [latlong]")
        ->check(CLI::IsMember({"latlong", "cube"}))
        ->type_name("LAYOUT");
    command->add_option("--size", options->size, "width of the lat-long, or of a cube face, in pixels [as fine as the light]")
        ->check(CLI::Range(2, 16384))
        ->type_name("N");
    command->add_flag("--json", options->as_json, "print as JSON");
    return [options] { return envmap(*options); };
}

}  // namespace burnish::cli
