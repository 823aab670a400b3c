// Shot documents checked and completed by the core, and the files that a frame pattern stands for.
#include "bind.h"
#include "json_objects.h"

#include <burnish/input/frames.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>

#include <pybind11/stl.h>

#include <string>

namespace burnish::python {
namespace {

namespace py = pybind11;

/// The document of a job, settings at their defaults left out. `source`: a shot file, or a document whose relative paths are as from
/// `folder`, and so are those in `settings`, which win.
py::object shot_document(const py::object& source, const py::dict& settings, const std::string& folder) {
    constexpr auto kWhere = "shot";
    const nlohmann::json given = to_json(source);
    Job job = given.is_string() ? read_shot_file(given.get<std::string>()) : job_from_json(given, kWhere, folder);
    set_settings(job, to_json(settings), kWhere);
    return from_json(job_to_json(job_from_json(job_to_json(job), kWhere, folder)));
}

}  // namespace

void bind_shot(py::module_& module) {
    module.def("shot_document", &shot_document, py::arg("source"), py::arg("settings"), py::arg("folder"));
    module.def("parse_frames", &parse_frames, py::arg("text"));
    module.def("has_frame_token", &has_frame_token, py::arg("pattern"));
    module.def("frame_file", &frame_file, py::arg("pattern"), py::arg("frame"));
    module.def("frames_on_disk", &frames_on_disk, py::arg("pattern"));
}

}  // namespace burnish::python
