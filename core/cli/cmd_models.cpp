// burnish models: the reflectance models with their parameters, the presets and the library of measured materials.
#include "command.h"

#include <burnish/base/json_fields.h>
#include <burnish/material/describe.h>
#include <burnish/material/import/import_material.h>
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
        parameters.push_back({{"name", p.name},
                              {"default", to_json_number(p.value)},
                              {"min", to_json_number(p.min)},
                              {"max", to_json_number(p.max)},
                              {"per_channel", p.per_channel},
                              {"help", p.help}});
    return {{"name", model.name},
            {"summary", model.summary},
            {"source", model.source},
            {"reciprocal", model.reciprocal},
            {"anisotropic", model.anisotropic},
            {"own_width", model.own_width},
            {"parameters", parameters}};
}

void print_json() {
    json list = {{"models", json::array()}, {"presets", json::object()}};
    for (const ModelInfo& model : models()) list["models"].push_back(as_json(model));
    for (const Material& preset : presets()) list["presets"][preset.name] = material_to_json(preset);
    for (const std::string& name : library_names()) list["library"][name] = library_json(name);
    std::printf("%s\n", list.dump(2).c_str());
}

/// Each with what was left out of it.
void print_materials(const std::string& file, bool machine) {
    const json list = materials_json(file);
    if (machine) std::printf("%s\n", list.dump(2).c_str());
    for (const json& entry : machine ? json::array() : list) {
        std::printf("%s#%s\n  %s\n", file.c_str(), entry["name"].get<std::string>().c_str(), entry["material"].dump().c_str());
        for (const json& note : entry["notes"]) std::printf("  note: %s\n", note.get<std::string>().c_str());
    }
}

}  // namespace

Run add_models(CLI::App& app) {
    struct Options {
        std::string file;
        bool as_json = false;
    };
    auto* command =
        app.add_subcommand("models",
                           "Lists reflectance models, their parameters, material presets and the measured materials; or the "
                           "materials of a file");
    auto options = std::make_shared<Options>();
    command->add_option("FILE", options->file, "glTF (.gltf, .glb) or MaterialX (.mtlx): the materials in it");
    command->add_flag("--json", options->as_json, "print as JSON");
    return [options] {
        if (!options->file.empty())
            print_materials(options->file, options->as_json);
        else if (options->as_json)
            print_json();
        else
            std::printf("%s", describe_models().c_str());
        return 0;
    };
}

}  // namespace burnish::cli
