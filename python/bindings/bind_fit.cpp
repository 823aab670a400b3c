// Fits of measured tables.
#include "bind.h"
#include "json_objects.h"
#include "python_progress.h"

#include <burnish/fit/fit.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/model.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace burnish::python {
namespace {

namespace py = pybind11;

py::object fit(const std::filesystem::path& table, const std::optional<std::string>& model, int lobes, bool all_lobes,
               const std::map<std::string, std::pair<double, double>>& bounds, py::object callback) {
    FitSettings settings;
    if (model) settings.model = model_by_name(*model);
    settings.max_lobes = lobes, settings.fixed_lobes = all_lobes;
    for (const auto& [name, range] : bounds) settings.bounds[name] = {range.first, range.second};
    PythonProgress progress(std::move(callback));
    return from_json(progress.run([&](const Progress& report) {
        const std::shared_ptr<const MeasuredBrdf> data = read_measured(table.string());
        return fit_report(*data, fit_material(*data, settings, report));
    }));
}

}  // namespace

void bind_fit(py::module_& module) {
    module.def("fit", &fit, py::arg("table"), py::arg("model"), py::arg("lobes"), py::arg("all_lobes"), py::arg("bounds"),
               py::arg("progress"));
}

}  // namespace burnish::python
