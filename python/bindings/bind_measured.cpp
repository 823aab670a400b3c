// Measured reflectance on arrays of directions.
#include "arrays.h"
#include "bind.h"
#include "docstrings_material.h"
#include "json_objects.h"

#include <burnish/material/measured/describe_measured.h>
#include <burnish/material/measured/merl_table.h>
#include <burnish/material/measured/read_measured.h>

namespace burnish::python {
namespace {

using Measured = std::shared_ptr<const MeasuredBrdf>;

/// What Python holds.
struct MeasuredHandle {
    Measured brdf;
};

MeasuredHandle read(const py::object& path) {
    const std::string file = to_json(path).get<std::string>();
    const py::gil_scoped_release unlocked;
    return {read_measured(file)};
}

FloatArray eval(const MeasuredHandle& measured, const FloatArray& wo, const FloatArray& wi) {
    const auto count = same_rows(rows(wo, 3, "wo"), rows(wi, 3, "wi"), "wo, wi");
    return triples(count, [&](py::ssize_t i) { return measured.brdf->eval(vec3(wo, i), vec3(wi, i)); });
}

py::tuple samples(const MeasuredHandle& measured) {
    const std::vector<BrdfSample> all = measured.brdf->samples();
    const auto column = [&](auto member) {
        return triples(static_cast<py::ssize_t>(all.size()),
                       [&](py::ssize_t i) { return all[static_cast<size_t>(i)].*member; });
    };
    return py::make_tuple(column(&BrdfSample::wo), column(&BrdfSample::wi), column(&BrdfSample::f));
}

py::object about(const MeasuredHandle& measured) {
    nlohmann::json description;
    {
        const py::gil_scoped_release unlocked;
        description = describe_measured_json(*measured.brdf);
    }
    return from_json(description);
}

void write_merl(const MeasuredHandle& measured, const py::object& path) {
    const std::string file = to_json(path).get<std::string>();
    const py::gil_scoped_release unlocked;
    if (const auto* merl = dynamic_cast<const MerlTable*>(measured.brdf.get())) return merl->write(file);
    if (!measured.brdf->is_isotropic())
        throw Error(ErrorCode::bad_argument, measured.brdf->file() + ": is anisotropic, which MERL's tables cannot hold");
    MerlTable([&](const Vec3f& wo, const Vec3f& wi) { return measured.brdf->eval(wo, wi); }).write(file);
}

}  // namespace

void bind_measured(py::module_& module) {
    py::class_<MeasuredHandle>(module, "Measured", docs::Measured)
        .def(py::init(&read), py::arg("path"))
        .def("eval", &eval, py::arg("wo"), py::arg("wi"), docs::Measured_eval)
        .def("samples", &samples, docs::Measured_samples)
        .def("info", &about, docs::Measured_info)
        .def("write_merl", &write_merl, py::arg("path"), docs::Measured_write_merl)
        .def_property_readonly("is_isotropic", [](const MeasuredHandle& m) { return m.brdf->is_isotropic(); })
        .def_property_readonly("transmits", [](const MeasuredHandle& m) { return m.brdf->transmits(); });
}

}  // namespace burnish::python
