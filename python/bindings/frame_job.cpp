#include "frame_job.h"

#include "arrays.h"
#include "json_objects.h"
#include "light.h"

#include <burnish/base/parallel.h>
#include <burnish/composite/sample_grid.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/savings.h>
#include <burnish/job/settings.h>

namespace burnish::python {
namespace {

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

/// A frame from arrays, one that was read already, or from its file where there is neither.
std::shared_ptr<const AovFrame> frame_from_python(const py::object& arrays, const Job& job, const Wardrobe& wardrobe,
                                                  const std::string& file, FramePart part, PythonProgress& progress) {
    if (py::isinstance<AovFrame>(arrays)) return arrays.cast<std::shared_ptr<AovFrame>>();
    std::map<Role, Image> layers;
    if (!arrays.is_none()) layers = layers_from_python(arrays);
    const std::string camera = part == FramePart::picture ? "" : job.camera;
    return progress.run([&](const Progress&) {
        return std::make_shared<const AovFrame>(arrays.is_none() ? read_job_frame(job, wardrobe, file, camera, part, job.view)
                                                                 : frame_from_layers(std::move(layers), camera));
    });
}

}  // namespace

FrameJob::FrameJob(const py::object& arrays, const py::object& fine_arrays, const py::object& light, const py::object& masks,
                   const py::dict& settings, PythonProgress& progress) {
    set_settings(job, to_json(settings), "composite");
    job.output.diagnostics = true;
    if (!masks.is_none()) assignment = masks_from_python(job, masks);
    const ThreadLimit limit(job.threads);
    wardrobe = prepare_wardrobe(job);
    const bool has_fine = !fine_arrays.is_none() || !job.fine_aovs.empty();
    frame = frame_from_python(arrays, job, wardrobe, job.aovs, has_fine ? FramePart::picture : FramePart::whole, progress);
    if (has_fine) fine = frame_from_python(fine_arrays, job, wardrobe, job.fine_aovs, FramePart::surfaces, progress);
    if (fine) check_samples(sample_grid(*frame, *fine), *frame, *fine);
    environment = light_from_python(job, light, frame->renderer);
}

Rig FrameJob::load_rig() const {
    const ColorFlow color(job);
    const LightFrame of_light{frame->renderer, (fine ? *fine : *frame).camera, {}};
    Rig rig = build_rig(job, wardrobe.rules, color, environment, of_light);
    load_frame_lights(rig, color, of_light);
    return rig;
}

py::dict FrameJob::to_python(FrameResult&& result, const Look& look, const NamedValues<double>& seconds) const {
    ColorFlow(job).to_output(result.composite);
    FrameReport report = frame_report(job, *frame, samples(), look, result.tally);
    report.seconds.insert(report.seconds.begin(), seconds.begin(), seconds.end());
    const auto add_lines = [](const auto& lines, auto& all) { all.insert(all.end(), lines.begin(), lines.end()); };
    const LightNotes told = look.rig.told();
    add_lines(look.wardrobe.warnings, report.warnings), add_lines(told.warnings, report.warnings);
    add_lines(told.notes, report.notes), add_lines(saved_light(look.rig), report.saved);
    py::dict layers;
    const auto add = [&](const char* name, Image& image) {
        if (!image.empty()) layers[name] = to_array(std::move(image));
    };
    add("beauty", result.composite.beauty), add("overlay", result.composite.overlay), add("diffuse", result.composite.diffuse);
    add("validity", result.validity), add("samples", result.shaded.samples), add("error", result.shaded.standard_error);
    layers["report"] = from_json(report_to_json(report));
    return layers;
}

}  // namespace burnish::python
