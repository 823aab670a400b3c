// The parts of the module, each bound in its own file.
#pragma once

#include <pybind11/pybind11.h>

namespace burnish::python {

void bind_errors(pybind11::module_& module);
void bind_tables(pybind11::module_& module);
void bind_material(pybind11::module_& module);
void bind_measured(pybind11::module_& module);
void bind_light(pybind11::module_& module);
void bind_bandwidth(pybind11::module_& module);
void bind_frame(pybind11::module_& module);
void bind_job(pybind11::module_& module);
void bind_fit(pybind11::module_& module);
void bind_factor(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_preview(pybind11::module_& module);
void bind_shot(pybind11::module_& module);

}  // namespace burnish::python
