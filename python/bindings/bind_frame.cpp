// A frame that is read once and shaded many times, and shot files as the settings they set.
#include "bind.h"
#include "docstrings_frame.h"
#include "json_objects.h"

#include <burnish/input/frame.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>
#include <burnish/sampling/density.h>

#include <memory>
#include <string>

namespace burnish::python {
namespace {

namespace py = pybind11;

std::shared_ptr<AovFrame> read_frame(const py::kwargs& settings) {
    Job job;
    set_settings(job, to_json(settings), "Frame");
    const py::gil_scoped_release unlocked;
    return std::make_shared<AovFrame>(
        read_job_frame(job, prepare_wardrobe(job), job.aovs, job.camera, FramePart::whole, job.view));
}

/// Settings by name as the job holds them, those at their defaults left out; `source`: a shot file, or settings by name.
py::object shot_settings(const py::object& source) {
    Job job;
    if (py::isinstance<py::dict>(source))
        set_settings(job, to_json(source), "settings");
    else
        job = read_shot_file(py::str(source));
    nlohmann::json values = nlohmann::json::object();
    for (const Setting& setting : settings())
        if (nlohmann::json value = setting.get(job); value != setting.default_value())
            values[std::string(setting.name)] = std::move(value);
    return from_json(values);
}

/// What the density of settings by name comes to. `pixels`: samples of the whole frame; `is_near`: some light used is near.
const char* settled_density_name(const py::dict& settings, size_t pixels, bool is_near) {
    Job job;
    set_settings(job, to_json(settings), "settings");
    const ShadingDensity settled = settled_density(job.density.density, job.estimator, pixels, is_near);
    return settled == ShadingDensity::sparse ? "sparse" : "dense";
}

}  // namespace

void bind_frame(py::module_& module) {
    py::class_<AovFrame, std::shared_ptr<AovFrame>>(module, "Frame", docs::Frame)
        .def(py::init(&read_frame))
        .def_property_readonly("width", [](const AovFrame& frame) { return frame.data_window.width; })
        .def_property_readonly("height", [](const AovFrame& frame) { return frame.data_window.height; })
        .def_property_readonly(
            "up", [](const AovFrame& frame) { return settled_up(UpAxis::automatic, frame.renderer) == UpAxis::z ? "z" : "y"; });
    module.def("shot_settings", &shot_settings, py::arg("source"));
    module.def("settled_density", &settled_density_name, py::arg("settings"), py::arg("pixels"), py::arg("is_near"));
}

}  // namespace burnish::python
