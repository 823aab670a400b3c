// A material on a ball.
#include "arrays.h"
#include "bind.h"
#include "json_objects.h"

#include <burnish/job/material_ball.h>
#include <burnish/material/library.h>

namespace burnish::python {
namespace {

FloatArray preview(const py::object& description, const py::object& environment, int size) {
    if (size < 1 || size > 4096)
        throw Error(ErrorCode::bad_argument, "size: expected 1 to 4096, found " + std::to_string(size));
    const nlohmann::json json = to_json(description), light_file = to_json(environment);
    BallSettings settings;
    settings.size = size;
    Image ball;
    {
        const py::gil_scoped_release unlocked;
        const Material material =
            json.is_string() ? find_material(json.get<std::string>()) : material_from_json(json, "material", "material");
        const BallLight light = light_file.is_null() ? BallLight::sky() : BallLight::load(light_file.get<std::string>());
        ball = render_ball(material, light, settings);
    }
    return to_array(std::move(ball));
}

}  // namespace

void bind_preview(py::module_& module) {
    module.def("preview", &preview, py::arg("material"), py::arg("environment"), py::arg("size"));
}

}  // namespace burnish::python
