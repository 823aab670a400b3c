// What Python may give as the environment: a path, a picture as array, an Environment, or None for the job's own; null where the
// job has other lights and no environment.
#pragma once

#include <burnish/input/renderer.h>
#include <burnish/job/job.h>

#include <pybind11/pybind11.h>

#include <memory>

namespace burnish::python {

std::shared_ptr<const Environment> light_from_python(Job& job, const pybind11::object& light, Renderer renderer);

}  // namespace burnish::python
