// burnish::Error as the exceptions of burnish/errors.py.
#include "bind.h"

#include <burnish/base/error.h>

namespace burnish::python {

namespace py = pybind11;

void bind_errors(py::module_&) {
    py::register_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Error& error) {
            const py::object by_code = py::module_::import("burnish.errors").attr("BY_CODE");
            const py::object type = by_code[py::str(std::string(error_name(error.code())))];
            PyErr_SetString(type.ptr(), error.what());
        }
    });
}

}  // namespace burnish::python
