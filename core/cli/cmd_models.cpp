// burnish models: the reflectance models with their parameters, the presets and the library of measured materials.
#include "command.h"

#include <burnish/material/library.h>
#include <burnish/material/measured_library.h>
#include <burnish/material/model.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

using nlohmann::json;

json as_json(const ModelInfo& model) {
    json parameters = json::array();
    for (const ModelParameter& p : model.parameters)
        parameters.push_back({{"name", p.name}, {"default", p.value}, {"min", p.min}, {"max", p.max}, {"help", p.help}});
    return {{"name", model.name},
            {"summary", model.summary},
            {"source", model.source},
            {"reciprocal", model.reciprocal},
            {"parameters", parameters}};
}

void print_json() {
    json list = {{"models", json::array()}, {"presets", json::object()}};
    for (const ModelInfo& model : models()) list["models"].push_back(as_json(model));
    for (const Material& preset : presets()) list["presets"][preset.name] = material_to_json(preset);
    for (const std::string& name : library_names()) list["library"][name] = library_json(name);
    std::printf("%s\n", list.dump(2).c_str());
}

/// Names without their common prefix, filled to lines.
void print_library() {
    constexpr size_t kLine = 110;
    const std::string prefix = "merl:";
    std::string line;
    std::printf("library, %zu measured materials (MERL) as sgd lobes, used as %sNAME:\n", library_names().size(),
                prefix.c_str());
    for (const std::string& name : library_names()) {
        const std::string word = " " + name.substr(prefix.size());
        if (line.size() + word.size() > kLine) std::printf("%s\n", line.c_str()), line.clear();
        line += word;
    }
    std::printf("%s\n", line.c_str());
}

void print_text() {
    for (const ModelInfo& model : models()) {
        std::printf("%-10s %s\n           %s\n", std::string(model.name).c_str(), std::string(model.summary).c_str(),
                    std::string(model.source).c_str());
        for (const ModelParameter& p : model.parameters)
            std::printf("           %-8s %s, %g to %g [%g]\n", std::string(p.name).c_str(), std::string(p.help).c_str(), p.min,
                        p.max, p.value);
    }
    std::printf("\npresets:");
    for (const Material& preset : presets()) std::printf(" %s", preset.name.c_str());
    std::printf("\n\n");
    print_library();
}

}  // namespace

Run add_models(CLI::App& app) {
    auto* command =
        app.add_subcommand("models", "Lists reflectance models, their parameters, material presets and the measured materials");
    auto machine = std::make_shared<bool>(false);
    command->add_flag("--json", *machine, "print as JSON");
    return [machine] {
        if (*machine)
            print_json();
        else
            print_text();
        return 0;
    };
}

}  // namespace burnish::cli
