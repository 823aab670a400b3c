// Factors and their making.
#include "arrays.h"
#include "bind.h"
#include "docstrings_factor.h"
#include "json_objects.h"
#include "light.h"
#include "python_progress.h"

#include <burnish/factor/factors_file.h>
#include <burnish/factor/glsl.h>
#include <burnish/job/make_factors.h>
#include <burnish/output/factors_writer.h>

#include <algorithm>

namespace burnish::python {
namespace {

StoredFactors read(const py::object& path) {
    const std::string file = to_json(path).get<std::string>();
    const py::gil_scoped_release unlocked;
    return read_factors(file);
}

FloatArray evaluate(const StoredFactors& stored, const FloatArray& a, const FloatArray& b) {
    const auto count = same_rows(rows(a, 3, "a"), rows(b, 3, "b"), "a, b");
    return triples(count, [&](py::ssize_t i) { return stored({vec3(a, i), vec3(b, i)}); });
}

std::vector<std::pair<std::string, const FactorMap*>> maps_of(const StoredFactors& stored) {
    std::vector<std::pair<std::string, const FactorMap*>> maps;
    for (size_t term = 0; term < stored.factors.terms.size(); ++term)
        for (int map = 0; map < stored.factors.parametrization->map_count(); ++map)
            maps.emplace_back(map_name(*stored.factors.parametrization, map, term), &stored.factors.terms[term][map]);
    return maps;
}

FloatArray map_of(const StoredFactors& stored, const std::string& name) {
    std::string known;
    for (const auto& [each, map] : maps_of(stored)) {
        known += (known.empty() ? "" : ", ") + each;
        if (each != name) continue;
        Image image(map->layout.width(), map->layout.height(), 3);
        for (size_t i = 0; i < image.pixel_count(); ++i) std::copy_n(&map->texels[i].x, 3, image.at(i));
        return to_array(std::move(image));
    }
    throw Error(ErrorCode::bad_argument, "there is no map \"" + name + "\"; the maps are " + known);
}

py::tuple factor(const py::object& light, const py::dict& fields, py::object callback) {
    FactorJob job = factor_job_from_json(to_json(fields), "factor");
    const bool has_light = !light.is_none() || !job.scene.environment.empty();
    const std::shared_ptr<const Environment> environment =
        has_light ? light_from_python(job.scene, light, Renderer::unknown) : nullptr;
    PythonProgress progress(std::move(callback));
    FactorReport report = progress.run([&](const Progress& told) { return make_factors(job, environment, told); });
    const py::object description = from_json(factor_report_to_json(report));
    return py::make_tuple(std::move(report.stored), description);
}

}  // namespace

void bind_factor(py::module_& module) {
    py::class_<StoredFactors>(module, "Factors", docs::Factors)
        .def(py::init(&read), py::arg("path"))
        .def("evaluate", &evaluate, py::arg("a"), py::arg("b"), docs::Factors_evaluate)
        .def("map", &map_of, py::arg("name"), docs::Factors_map)
        .def(
            "glsl", [](const StoredFactors& stored) { return glsl_of(stored); }, docs::Factors_glsl)
        .def(
            "write",
            [](const StoredFactors& stored, const py::object& path) {
                write_factors(to_json(path).get<std::string>(), stored);
            },
            py::arg("path"), docs::Factors_write)
        .def_property_readonly("info", [](const StoredFactors& stored) { return from_json(factors_to_json(stored)); })
        .def_property_readonly("maps", [](const StoredFactors& stored) {
            py::list names;
            for (const auto& [name, map] : maps_of(stored)) names.append(name);
            return names;
        });
    module.def("factor", &factor, py::arg("light"), py::arg("fields"), py::arg("progress"));
}

}  // namespace burnish::python
