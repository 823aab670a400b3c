// burnish info: what burnish sees in a file, why, and what it can do with it.
#include "command.h"

#include <burnish/input/exr_reader.h>
#include <burnish/input/info.h>
#include <burnish/material/measured/describe_measured.h>
#include <burnish/material/measured/read_measured.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

int print_measured(const std::string& file, bool as_json) {
    const auto measured = read_measured(file);
    const std::string text = as_json ? describe_measured_json(*measured).dump(2) + "\n" : describe_measured(*measured);
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace

Run add_info(CLI::App& app) {
    struct Options {
        std::string file, view;
        bool as_json = false;
    };
    auto* command = app.add_subcommand(
        "info", "Shows the layers, roles, camera and ids of a frame, and what it lacks; or what a measured reflectance holds");
    auto options = std::make_shared<Options>();
    command->add_option("FILE", options->file, "an EXR, or a measurement (.binary, .brdf, .alta, .dat, .gonio)")->required();
    command->add_option("--view", options->view, "view of a multi-view file")->type_name("NAME");
    command->add_flag("--json", options->as_json, "print as JSON");
    return [options] {
        if (is_measured_name(options->file)) return print_measured(options->file, options->as_json);
        ReadOptions read;
        read.cryptomattes = true;
        read.view = options->view;
        const AovFrame frame = read_frame(options->file, read);
        const std::string text = options->as_json ? describe_json(frame).dump(2) + "\n" : describe(frame);
        std::fputs(text.c_str(), stdout);
        return 0;
    };
}

}  // namespace burnish::cli
