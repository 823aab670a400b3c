// Whole jobs: with files as the command line runs them, and one frame in memory, at once or step by step.
#include "bind.h"
#include "frame_job.h"
#include "json_objects.h"

#include <burnish/base/parallel.h>
#include <burnish/job/refinement.h>
#include <burnish/job/run.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>
#include <burnish/job/stages.h>

namespace burnish::python {
namespace {

namespace py = pybind11;

py::object run_job(const py::object& source, const py::dict& settings, const py::object& callback) {
    const nlohmann::json document = to_json(source);
    Job job = document.is_string() ? read_shot_file(document.get<std::string>()) : job_from_json(document, "job");
    set_settings(job, to_json(settings), "job");
    const Report report = PythonProgress(callback).run([&](const Progress& progress) { return run(job, progress); });
    return from_json(report_to_json(report));
}

py::dict composite_frame(const py::object& arrays, const py::object& fine_arrays, const py::object& light,
                         const py::object& masks, const py::dict& settings, const py::object& callback) {
    PythonProgress python_progress(callback);
    FrameJob given(arrays, fine_arrays, light, masks, settings, python_progress);
    const ThreadLimit limit(given.job.threads);
    NamedValues<double> seconds;
    Look look;
    FrameResult result = python_progress.run([&](const Progress& progress) {
        Rig rig = timed(seconds, "light", [&] { return given.load_rig(); });
        look = prepare_look(given.job, given.wardrobe, std::move(rig), {given.sample_count()});
        return run_frame(given.job, given.picture(), given.samples(), look, given.masked(), progress);
    });
    return given.to_python(std::move(result), look, seconds);
}

/// What `burnish.refine` steps through.
class FrameRefinement {
public:
    FrameRefinement(const py::object& arrays, const py::object& fine_arrays, const py::object& light, const py::object& masks,
                    const py::dict& settings, const py::object& callback)
        : m_progress(callback), m_given(arrays, fine_arrays, light, masks, settings, m_progress) {
        const ThreadLimit limit(m_given.job.threads);
        m_progress.run([&](const Progress&) {
            Rig rig = timed(m_seconds, "light", [&] { return m_given.load_rig(); });
            m_refinement.emplace(m_given.job, m_given.picture(), m_given.samples(), m_given.wardrobe, std::move(rig),
                                 m_given.masked());
        });
    }

    /// The next step's layers; None after the last.
    py::object next() {
        if (m_refinement->is_done()) return py::none();
        const ThreadLimit limit(m_given.job.threads);
        RefinedFrame refined = m_progress.run([&](const Progress& progress) { return m_refinement->next(progress); });
        py::dict layers = m_given.to_python(std::move(refined.result), m_refinement->look(), std::exchange(m_seconds, {}));
        layers["step"] = refined.step, layers["label"] = refined.label, layers["is_final"] = refined.is_final;
        return std::move(layers);
    }

private:
    PythonProgress m_progress;
    FrameJob m_given;
    NamedValues<double> m_seconds;  // of what came before the first step
    std::optional<Refinement> m_refinement;
};

}  // namespace

void bind_job(py::module_& module) {
    module.def("run", &run_job, py::arg("job"), py::arg("settings"), py::arg("progress"));
    module.def("composite", &composite_frame, py::arg("frame"), py::arg("fine"), py::arg("light"), py::arg("masks"),
               py::arg("settings"), py::arg("progress"));
    py::class_<FrameRefinement>(module, "Refinement", "The steps of burnish.refine.")
        .def(py::init<const py::object&, const py::object&, const py::object&, const py::object&, const py::dict&,
                      const py::object&>(),
             py::arg("frame"), py::arg("fine"), py::arg("light"), py::arg("masks"), py::arg("settings"), py::arg("progress"))
        .def("next", &FrameRefinement::next, "Layers of the next step, or None after the last.");
}

}  // namespace burnish::python
