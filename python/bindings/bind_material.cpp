// One lobe on arrays of directions, and the energy check: what tests and tools need of the reflectance models.
#include "arrays.h"
#include "bind.h"
#include "docstrings_material.h"
#include "json_objects.h"

#include <burnish/material/albedo.h>
#include <burnish/material/import/import_material.h>
#include <burnish/material/library.h>
#include <burnish/material/lobe.h>

#include <pybind11/stl/filesystem.h>

namespace burnish::python {
namespace {

LobeParameters lobe_from_python(const py::dict& description) {
    const nlohmann::json material = {{"lobes", nlohmann::json::array({to_json(description)})}};
    return material_from_json(material, "lobe", "lobe").lobes.front();
}

FloatArray eval(const LobeParameters& lobe, const FloatArray& wo, const FloatArray& wi) {
    const auto count = same_rows(rows(wo, 3, "wo"), rows(wi, 3, "wi"), "wo, wi");
    return visit_lobe(lobe, [&](const auto& own) {
        return triples(count, [&](py::ssize_t i) { return own.eval(vec3(wo, i), vec3(wi, i)); });
    });
}

FloatArray pdf(const LobeParameters& lobe, const FloatArray& wo, const FloatArray& wi) {
    const auto count = same_rows(rows(wo, 3, "wo"), rows(wi, 3, "wi"), "wo, wi");
    return visit_lobe(lobe, [&](const auto& own) {
        return scalars(count, [&](py::ssize_t i) { return own.pdf(vec3(wo, i), vec3(wi, i)); });
    });
}

FloatArray sample(const LobeParameters& lobe, const FloatArray& wo, const FloatArray& u) {
    const auto count = same_rows(rows(wo, 3, "wo"), rows(u, 2, "u"), "wo, u");
    return visit_lobe(lobe, [&](const auto& own) {
        return triples(count, [&](py::ssize_t i) { return own.sample(vec3(wo, i), Vec2f(u.at(i, 0), u.at(i, 1))); });
    });
}

FloatArray density(const LobeParameters& lobe, const FloatArray& wm) {
    return visit_lobe(lobe, [&](const auto& own) {
        return scalars(rows(wm, 3, "wm"), [&](py::ssize_t i) { return own.model.D(vec3(wm, i)); });
    });
}

FloatArray albedo(const LobeParameters& lobe, const FloatArray& wo, int samples) {
    return triples(rows(wo, 3, "wo"), [&](py::ssize_t i) { return directional_albedo(lobe, vec3(wo, i), samples); });
}

py::dict energy(const py::object& description) {
    const nlohmann::json json = to_json(description);
    const Material material =
        json.is_string() ? find_material(json.get<std::string>()) : material_from_json(json, "material", "material");
    const EnergyCheck check = check_energy(material);
    py::dict result;
    result["max_albedo"] = check.max_albedo, result["theta_o_deg"] = check.theta_o_deg;
    return result;
}

py::object materials_of(const std::filesystem::path& path) { return from_json(materials_json(path.string())); }

}  // namespace

void bind_material(py::module_& module) {
    py::class_<LobeParameters>(module, "Lobe", docs::Lobe)
        .def(py::init(&lobe_from_python), py::arg("description"))
        .def("eval", &eval, py::arg("wo"), py::arg("wi"), docs::Lobe_eval)
        .def("pdf", &pdf, py::arg("wo"), py::arg("wi"), docs::Lobe_pdf)
        .def("sample", &sample, py::arg("wo"), py::arg("u"), docs::Lobe_sample)
        .def("D", &density, py::arg("wm"), docs::Lobe_D)
        .def("albedo", &albedo, py::arg("wo"), py::arg("samples") = 4096, docs::Lobe_albedo);
    module.def("check_energy", &energy, py::arg("material"));
    module.def("read_materials", &materials_of, py::arg("path"));
}

}  // namespace burnish::python
