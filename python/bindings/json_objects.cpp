#include "json_objects.h"

#include <burnish/base/error.h>

#include <string>

namespace burnish::python {
namespace {

namespace py = pybind11;
using nlohmann::json;

json to_json_at(py::handle object, int depth) {
    constexpr int kDeepest = 64;
    if (depth > kDeepest) throw Error(ErrorCode::bad_argument, "job: nested deeper than 64 levels");
    if (object.is_none()) return nullptr;
    if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
    if (py::isinstance<py::int_>(object)) return object.cast<std::int64_t>();
    if (py::isinstance<py::float_>(object)) return object.cast<double>();
    if (py::isinstance<py::str>(object)) return object.cast<std::string>();
    if (py::isinstance<py::dict>(object)) {
        json result = json::object();
        for (const auto& [key, value] : object.cast<py::dict>())
            result[py::str(key).cast<std::string>()] = to_json_at(value, depth + 1);
        return result;
    }
    if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
        json result = json::array();
        for (const py::handle item : object) result.push_back(to_json_at(item, depth + 1));
        return result;
    }
    if (py::hasattr(object, "__fspath__")) return py::str(object.attr("__fspath__")()).cast<std::string>();
    if (py::hasattr(object, "tolist")) return to_json_at(object.attr("tolist")(), depth + 1);
    throw Error(ErrorCode::bad_argument,
                "job: cannot use a " + py::str(py::type::handle_of(object).attr("__name__")).cast<std::string>());
}

}  // namespace

json to_json(py::handle object) { return to_json_at(object, 0); }

py::object from_json(const json& value) {
    if (value.is_object()) {
        py::dict result;
        for (const auto& [key, field] : value.items()) result[py::str(key)] = from_json(field);
        return result;
    }
    if (value.is_array()) {
        py::list result;
        for (const json& item : value) result.append(from_json(item));
        return result;
    }
    if (value.is_string()) return py::str(value.get<std::string>());
    if (value.is_boolean()) return py::bool_(value.get<bool>());
    if (value.is_number_integer()) return py::int_(value.get<std::int64_t>());
    if (value.is_number()) return py::float_(value.get<double>());
    return py::none();
}

}  // namespace burnish::python
