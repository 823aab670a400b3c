// What is in a file, and how far a picture is from its reference.
#include "arrays.h"
#include "bind.h"
#include "json_objects.h"

#include <burnish/input/exr_reader.h>
#include <burnish/input/info.h>
#include <burnish/output/compare.h>

#include <optional>

namespace burnish::python {
namespace {

py::object info(const py::object& path) {
    const std::string file = to_json(path).get<std::string>();
    ReadOptions options;
    options.cryptomattes = true;
    nlohmann::json description;
    {
        const py::gil_scoped_release unlocked;
        description = describe_json(read_frame(file, options));
    }
    return from_json(description);
}

py::dict compare(const py::object& a, const py::object& b, const py::object& mask) {
    std::optional<Image> covered;
    if (!mask.is_none()) covered = to_image(mask, "mask");
    const Comparison c = compare_images(to_image(a, "a"), to_image(b, "b"), covered ? &*covered : nullptr);
    py::dict result;
    result["psnr_db"] = c.display_psnr_db, result["relative_rms"] = c.relative_rms, result["relmse"] = c.rel_mse;
    result["largest_error"] = c.largest_error, result["largest_at"] = py::make_tuple(c.largest_x, c.largest_y);
    result["pixels"] = c.pixels, result["non_finite"] = c.non_finite;
    return result;
}

}  // namespace

void bind_files(py::module_& module) {
    module.def("info", &info, py::arg("path"));
    module.def("compare", &compare, py::arg("a"), py::arg("b"), py::arg("mask"));
}

}  // namespace burnish::python
