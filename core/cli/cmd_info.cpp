// burnish info: what burnish sees in a file, why, and what it can do with it.
#include "command.h"

#include <burnish/input/exr_reader.h>
#include <burnish/input/info.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace burnish::cli {

Run add_info(CLI::App& app) {
    struct Options {
        std::string file, view;
        bool as_json = false;
    };
    auto* command = app.add_subcommand("info", "Shows the layers, roles, camera and ids of a frame, and what it lacks");
    auto options = std::make_shared<Options>();
    command->add_option("FILE", options->file, "an EXR")->required();
    command->add_option("--view", options->view, "view of a multi-view file")->type_name("NAME");
    command->add_flag("--json", options->as_json, "print as JSON");
    return [options] {
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
