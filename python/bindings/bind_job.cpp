// Whole jobs: with files as the command line runs them, and one frame in memory.
#include "arrays.h"
#include "bind.h"
#include "json_objects.h"
#include "light.h"
#include "python_progress.h"

#include <burnish/base/parallel.h>
#include <burnish/composite/sample_grid.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/run.h>
#include <burnish/job/run_frame.h>
#include <burnish/job/savings.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>
#include <burnish/job/stages.h>

namespace burnish::python {
namespace {

py::object run_job(const py::object& source, const py::dict& settings, const py::object& callback) {
    const nlohmann::json document = to_json(source);
    Job job = document.is_string() ? read_shot_file(document.get<std::string>()) : job_from_json(document, "job");
    set_settings(job, to_json(settings), "job");
    const Report report = PythonProgress(callback).run([&](const Progress& progress) { return run(job, progress); });
    return from_json(report_to_json(report));
}

std::map<Role, Image> layers_from_python(const py::dict& arrays) {
    std::map<Role, Image> layers;
    for (const auto& [key, array] : arrays) {
        const std::string name = py::str(key);
        layers[role_by_name(name)] = to_image(array, name);
    }
    return layers;
}

/// The rules are the masks: one per material, in the order of the dict.
Assignment masks_from_python(Job& job, const py::dict& arrays) {
    std::vector<Image> masks;
    job.material.clear(), job.assign.clear();
    for (const auto& [key, array] : arrays) {
        const std::string name = py::str(key);
        job.assign.push_back({name, {}, {}, {}});
        masks.push_back(to_image(array, "assign: " + name));
    }
    if (masks.empty()) throw Error(ErrorCode::bad_argument, "assign: expected at least one mask, found none");
    return assign_masks(masks);
}

py::dict to_python(FrameResult&& result, const FrameReport& report) {
    py::dict layers;
    const auto add = [&](const char* name, Image& image) {
        if (!image.empty()) layers[name] = to_array(std::move(image));
    };
    add("beauty", result.composite.beauty), add("overlay", result.composite.overlay), add("diffuse", result.composite.diffuse);
    add("validity", result.validity), add("samples", result.shaded.samples), add("error", result.shaded.standard_error);
    layers["report"] = from_json(report_to_json(report));
    return layers;
}

/// A frame from arrays, one that was read already, or from its file where there is neither.
std::shared_ptr<const AovFrame> frame_from_python(const py::object& arrays, const Job& job, const Wardrobe& wardrobe,
                                                  const std::string& file, FramePart part, PythonProgress& progress) {
    if (py::isinstance<AovFrame>(arrays)) return arrays.cast<std::shared_ptr<AovFrame>>();
    std::map<Role, Image> layers;
    if (!arrays.is_none()) layers = layers_from_python(arrays);
    const std::string camera = part == FramePart::picture ? "" : job.camera;
    return progress.run([&](const Progress&) {
        return std::make_shared<const AovFrame>(arrays.is_none() ? read_job_frame(job, wardrobe, file, camera, part)
                                                                 : frame_from_layers(std::move(layers), camera));
    });
}

Look look_of(const Job& job, Wardrobe wardrobe, std::shared_ptr<const Environment> environment, const LightFrame& of_light,
             NamedValues<double>& seconds) {
    const ColorFlow color(job);
    Rig rig = timed(seconds, "light", [&] {
        Rig loaded = build_rig(job, wardrobe.rules, color, std::move(environment), of_light);
        load_frame_lights(loaded, color, of_light);
        return loaded;
    });
    return timed(seconds, "tables", [&] { return prepare_look(job, std::move(wardrobe), std::move(rig)); });
}

py::dict composite_frame(const py::object& arrays, const py::object& fine_arrays, const py::object& light,
                         const py::object& masks, const py::dict& settings, const py::object& callback) {
    Job job;
    set_settings(job, to_json(settings), "composite");
    job.output.diagnostics = true;
    std::optional<Assignment> assignment;
    if (!masks.is_none()) assignment = masks_from_python(job, masks);
    PythonProgress python_progress(callback);
    const ThreadLimit limit(job.threads);
    Wardrobe wardrobe = prepare_wardrobe(job);
    const bool has_fine = !fine_arrays.is_none() || !job.fine_aovs.empty();
    const FramePart part = has_fine ? FramePart::picture : FramePart::whole;
    const auto given = frame_from_python(arrays, job, wardrobe, job.aovs, part, python_progress);
    const AovFrame& frame = *given;
    std::shared_ptr<const AovFrame> fine;
    if (has_fine) fine = frame_from_python(fine_arrays, job, wardrobe, job.fine_aovs, FramePart::surfaces, python_progress);
    if (fine) check_samples(sample_grid(frame, *fine), frame, *fine);
    const AovFrame* samples = fine.get();
    const auto environment = light_from_python(job, light, frame.renderer);
    const LightFrame of_light{frame.renderer, (fine ? *fine : frame).camera, {}};
    FrameReport report;
    FrameResult result = python_progress.run([&](const Progress& progress) {
        NamedValues<double> seconds;
        const Look look = look_of(job, std::move(wardrobe), environment, of_light, seconds);
        FrameResult done = run_frame(job, frame, samples, look, assignment ? &*assignment : nullptr, progress);
        ColorFlow(job).to_output(done.composite);
        report = frame_report(job, frame, samples, look, done.tally);
        report.seconds.insert(report.seconds.begin(), seconds.begin(), seconds.end());
        const auto add = [&](const auto& lines) { report.warnings.insert(report.warnings.end(), lines.begin(), lines.end()); };
        const LightNotes told = look.rig.told();
        add(look.wardrobe.warnings), add(told.warnings);
        report.notes.insert(report.notes.end(), told.notes.begin(), told.notes.end());
        std::ranges::copy(saved_light(look.rig), std::back_inserter(report.saved));
        return done;
    });
    return to_python(std::move(result), report);
}

}  // namespace

void bind_job(py::module_& module) {
    module.def("run", &run_job, py::arg("job"), py::arg("settings"), py::arg("progress"));
    module.def("composite", &composite_frame, py::arg("frame"), py::arg("fine"), py::arg("light"), py::arg("masks"),
               py::arg("settings"), py::arg("progress"));
}

}  // namespace burnish::python
