// Python objects <-> JSON values.
#pragma once

#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

namespace burnish::python {

/// None, bool, int, float, str, os.PathLike, numpy scalars and arrays, dicts, lists and tuples.
/// Throws Error(bad_argument) for anything else.
nlohmann::json to_json(pybind11::handle object);

pybind11::object from_json(const nlohmann::json& value);

}  // namespace burnish::python
