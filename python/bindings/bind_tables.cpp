// What burnish knows, as plain Python values: settings, roles, models, presets, the shot file's schema.
#include "bind.h"
#include "json_objects.h"

#include <burnish/base/json_fields.h>
#include <burnish/input/roles.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>
#include <burnish/material/library.h>
#include <burnish/material/measured_library.h>
#include <burnish/material/model.h>

#include <cmath>

namespace burnish::python {
namespace {

namespace py = pybind11;
using nlohmann::json;

json bound(double x) { return std::isfinite(x) ? json(x) : json(); }

py::object settings_table() {
    json table = json::array();
    for (const Setting& s : settings())
        table.push_back({{"name", s.name},
                         {"section", s.section},
                         {"key", s.key},
                         {"unit", s.unit},
                         {"help", s.help},
                         {"min", bound(s.range.min)},
                         {"max", bound(s.range.max)},
                         {"choices", s.choices},
                         {"default", s.default_value()}});
    return from_json(table);
}

py::object roles_table() {
    json table = json::object();
    for (const RoleInfo& role : roles()) table[std::string(role.name)] = {{"channels", role.channels}, {"help", role.help}};
    return from_json(table);
}

py::object models_table() {
    json table = json::object();
    for (const ModelInfo& model : models()) {
        json parameters = json::object();
        for (const ModelParameter& p : model.parameters)
            parameters[std::string(p.name)] = {{"default", to_json_number(p.value)},
                                               {"min", to_json_number(p.min)},
                                               {"max", to_json_number(p.max)},
                                               {"per_channel", p.per_channel},
                                               {"help", p.help}};
        table[std::string(model.name)] = {{"summary", model.summary},       {"source", model.source},
                                          {"reciprocal", model.reciprocal}, {"anisotropic", model.anisotropic},
                                          {"own_width", model.own_width},   {"parameters", parameters}};
    }
    return from_json(table);
}

py::object presets_table() {
    json table = json::object();
    for (const Material& preset : presets()) table[preset.name] = material_to_json(preset);
    return from_json(table);
}

py::object library_table() {
    json table = json::object();
    for (const std::string& name : library_names()) table[name] = library_json(name);
    return from_json(table);
}

}  // namespace

void bind_tables(py::module_& module) {
    module.def("settings", settings_table);
    module.def("roles", roles_table);
    module.def("models", models_table);
    module.def("presets", presets_table);
    module.def("library", library_table);
    module.def("shot_schema", [] { return from_json(shot_schema()); });
}

}  // namespace burnish::python
