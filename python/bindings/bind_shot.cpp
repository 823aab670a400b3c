// Shot documents checked and completed by the core, their frames run in several goes, and the files that a frame pattern stands for.
#include "bind.h"
#include "json_objects.h"
#include "python_progress.h"

#include <burnish/input/frames.h>
#include <burnish/job/run.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>

#include <pybind11/stl.h>

#include <memory>
#include <string>

namespace burnish::python {
namespace {

namespace py = pybind11;

constexpr auto kWhere = "shot";

/// The document of a job, settings at their defaults left out. `source`: a shot file, or a document whose relative paths are as from
/// `folder`, and so are those in `settings`, which win.
py::object shot_document(const py::object& source, const py::dict& settings, const std::string& folder) {
    const nlohmann::json given = to_json(source);
    Job job = given.is_string() ? read_shot_file(given.get<std::string>()) : job_from_json(given, kWhere, folder);
    set_settings(job, to_json(settings), kWhere);
    return from_json(job_to_json(job_from_json(job_to_json(job), kWhere, folder)));
}

std::unique_ptr<ShotRunner> make_runner(const py::dict& document) {
    return std::make_unique<ShotRunner>(job_from_json(to_json(document), kWhere));
}

py::object run_some(ShotRunner& runner, const std::string& frames, const py::object& callback) {
    const Report report = PythonProgress(callback).run([&](const Progress& progress) { return runner.run(frames, progress); });
    return from_json(report_to_json(report));
}

}  // namespace

void bind_shot(py::module_& module) {
    py::class_<ShotRunner>(module, "ShotRunner", "A shot that is run in several goes; light and tables are made once.")
        .def(py::init(&make_runner), py::arg("document"))
        .def("run", &run_some, py::arg("frames"), py::arg("progress"), "Run the frames of a range; the report.");
    module.def("shot_document", &shot_document, py::arg("source"), py::arg("settings"), py::arg("folder"));
    module.def("parse_frames", &parse_frames, py::arg("text"));
    module.def("has_frame_token", &has_frame_token, py::arg("pattern"));
    module.def("frame_file", &frame_file, py::arg("pattern"), py::arg("frame"));
    module.def("frames_on_disk", &frames_on_disk, py::arg("pattern"));
}

}  // namespace burnish::python
