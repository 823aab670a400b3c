// One frame in memory, as Python gives it: layers, masks, settings and light, ready to shade.
#pragma once

#include "python_progress.h"

#include <burnish/job/build_lights.h>
#include <burnish/job/look.h>
#include <burnish/job/run_frame.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

namespace burnish::python {

struct FrameJob {
    /// `arrays` and `fine_arrays`: role -> array, a frame that was read already, or None for the file the settings name. `masks`: None for the rules.
    FrameJob(const pybind11::object& arrays, const pybind11::object& fine_arrays, const pybind11::object& light,
             const pybind11::object& masks, const pybind11::dict& settings, PythonProgress& progress);

    const AovFrame& picture() const { return *frame; }
    const AovFrame* samples() const { return fine.get(); }
    size_t sample_count() const { return (fine ? *fine : *frame).pixel_count(); }
    const Assignment* masked() const { return assignment ? &*assignment : nullptr; }

    Rig load_rig() const;

    /// Layers by name and the report, to which `seconds` come first; `look` made it.
    pybind11::dict to_python(FrameResult&& result, const Look& look, const NamedValues<double>& seconds) const;

    Job job;
    std::optional<Assignment> assignment;
    Wardrobe wardrobe;
    std::shared_ptr<const AovFrame> frame, fine;  // fine: null where there is none
    std::shared_ptr<const Environment> environment;
};

}  // namespace burnish::python
