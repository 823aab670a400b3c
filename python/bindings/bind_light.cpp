// The environment on arrays of directions.
#include "arrays.h"
#include "bind.h"
#include "docstrings_light.h"
#include "json_objects.h"
#include "light.h"

#include <burnish/job/color_flow.h>
#include <burnish/job/look.h>
#include <burnish/job/settings.h>

#include <pybind11/stl.h>

namespace burnish::python {

std::shared_ptr<const Environment> light_from_python(Job& job, const py::object& light, Renderer renderer) {
    if (py::isinstance<Environment>(light)) return light.cast<std::shared_ptr<Environment>>();
    if (py::isinstance<py::array>(light)) {
        Image picture = to_image(light, "light");
        const py::gil_scoped_release unlocked;
        return light_from_picture(job, ColorFlow(job), std::move(picture), renderer);
    }
    if (!light.is_none()) set_settings(job, {{"env", to_json(light)}}, "light");
    if (job.environment.empty() && !job.lights.empty()) return nullptr;
    const py::gil_scoped_release unlocked;
    return load_light(job, ColorFlow(job), renderer);
}

namespace {

FloatArray world_to_light(const Environment& light) {
    FloatArray out(std::vector<py::ssize_t>{3, 3});
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) out.mutable_at(row, column) = light.world_to_light()[row][column];
    return out;
}

FloatArray lookup(const Environment& light, const FloatArray& d, const FloatArray& level) {
    if (level.ndim() > 1) throw Error(ErrorCode::size_mismatch, "level: expected a number or an array of shape (n,)");
    const bool one = level.ndim() == 0;
    const auto count = rows(d, 3, "d");
    if (!one) same_rows(count, level.size(), "d, level");
    return triples(count, [&](py::ssize_t i) { return light.pyramid().lookup(vec3(d, i), level.data()[one ? 0 : i]); });
}

FloatArray level_of(const Environment& light, const FloatArray& d, float solid_angle) {
    return scalars(rows(d, 3, "d"), [&](py::ssize_t i) { return light.pyramid().level(vec3(d, i), solid_angle); });
}

py::tuple sample(const Environment& light, const FloatArray& u) {
    const auto count = rows(u, 2, "u");
    FloatArray pdf(count);
    FloatArray d =
        triples(count, [&](py::ssize_t i) { return light.sample(Vec2f(u.at(i, 0), u.at(i, 1)), pdf.mutable_at(i)); });
    return py::make_tuple(d, pdf);
}

}  // namespace

void bind_light(py::module_& module) {
    py::class_<Environment, std::shared_ptr<Environment>>(module, "Environment", docs::Environment)
        .def(py::init([](const py::object& source, const py::kwargs& settings) {
                 Job job;
                 if (py::isinstance<Environment>(source)) {
                     const auto& light = source.cast<const Environment&>();
                     job.light = light.settings();
                     set_settings(job, to_json(settings), "");
                     return std::make_shared<Environment>(light.relit(job.light));
                 }
                 set_settings(job, to_json(settings), "");
                 return std::make_shared<Environment>(*light_from_python(job, source, Renderer::unknown));
             }),
             py::arg("source"))
        .def(
            "radiance",
            [](const Environment& light, const FloatArray& d) {
                return triples(rows(d, 3, "d"), [&](py::ssize_t i) { return light.radiance(vec3(d, i)); });
            },
            py::arg("d"), docs::Environment_radiance)
        .def("lookup", &lookup, py::arg("d"), py::arg("level"), docs::Environment_lookup)
        .def("level", &level_of, py::arg("d"), py::arg("solid_angle"), docs::Environment_level)
        .def("sample", &sample, py::arg("u"), docs::Environment_sample)
        .def(
            "pdf",
            [](const Environment& light, const FloatArray& d) {
                return scalars(rows(d, 3, "d"), [&](py::ssize_t i) { return light.pdf(vec3(d, i)); });
            },
            py::arg("d"), docs::Environment_pdf)
        .def_property_readonly("world_to_light", &world_to_light)
        .def_property_readonly(
            "gain", [](const Environment& light) { return py::make_tuple(light.gain().x, light.gain().y, light.gain().z); })
        .def_property_readonly("face_size", [](const Environment& light) { return light.face_size(); })
        .def_property_readonly("level_count", [](const Environment& light) { return light.pyramid().level_count(); })
        .def_property_readonly("notes", &Environment::notes)
        .def_property_readonly("warnings", &Environment::warnings);
}

}  // namespace burnish::python
