// Local bandwidths on arrays: of images, of distant light, of lobes.
#include "arrays.h"
#include "bind.h"
#include "docstrings_light.h"
#include "docstrings_material.h"

#include <burnish/frequency/light_bandwidth.h>
#include <burnish/frequency/lobe_bandwidth.h>
#include <burnish/frequency/local_bandwidth.h>
#include <burnish/light/environment.h>

#include <initializer_list>
#include <utility>

namespace burnish::python {
namespace {

template <class T>
T chosen(const std::string& field, const std::string& name, std::initializer_list<std::pair<const char*, T>> choices) {
    std::string known;
    for (const auto& [choice, value] : choices) {
        if (name == choice) return value;
        known += (known.empty() ? "" : ", ") + std::string(choice);
    }
    throw Error(ErrorCode::bad_argument, field + ": expected one of " + known + ", found \"" + name + "\"");
}

float share(const std::string& field, float value) {
    if (value > 0.0f && value < 1.0f) return value;
    throw Error(ErrorCode::bad_argument, field + ": expected a number in (0, 1), found " + std::to_string(value));
}

FloatArray local_bandwidth_of(const FloatArray& image, const std::string& rule, float quantile, float epsilon, float contrast,
                              const std::string& surround) {
    BandwidthSettings settings;
    settings.rule = chosen<BandRule>("rule", rule, {{"energy", BandRule::energy}, {"maxima", BandRule::maxima}});
    settings.quantile = share("quantile", quantile), settings.epsilon = share("epsilon", epsilon);
    settings.contrast = share("contrast", contrast);
    settings.surround = chosen<Surround>(
        "surround", surround, {{"zero", Surround::zero}, {"repeat", Surround::repeat}, {"latlong", Surround::latlong}});
    const Image picture = to_image(image, "image");
    Image nu;
    {
        const py::gil_scoped_release unlocked;
        nu = local_bandwidth(picture, settings);
    }
    return to_array(std::move(nu));
}

FloatArray nu_rho(const LobeBandwidth& lobe, const FloatArray& cos_o) {
    if (cos_o.ndim() != 1) throw Error(ErrorCode::size_mismatch, "cos_o: expected an array of shape (n,)");
    return scalars(cos_o.size(), [&](py::ssize_t i) { return lobe.nu_rho(cos_o.at(i)); });
}

FloatArray at(const LobeBandwidth& lobe, const FloatArray& wo, const FloatArray& wi) {
    const auto count = same_rows(rows(wo, 3, "wo"), rows(wi, 3, "wi"), "wo, wi");
    return scalars(count, [&](py::ssize_t i) { return lobe.at(vec3(wo, i), vec3(wi, i)); });
}

}  // namespace

void bind_bandwidth(py::module_& module) {
    const py::call_guard<py::gil_scoped_release> unlocked;
    py::class_<LightBandwidth>(module, "LightBandwidth", docs::LightBandwidth)
        .def(py::init<const Environment&>(), py::arg("light"), unlocked)
        .def(
            "at",
            [](const LightBandwidth& light, const FloatArray& d, float radius) {
                return scalars(rows(d, 3, "d"), [&](py::ssize_t i) { return light.at(vec3(d, i), radius); });
            },
            py::arg("d"), py::arg("radius"), docs::LightBandwidth_at);
    py::class_<LobeBandwidth>(module, "LobeBandwidth", docs::LobeBandwidth)
        .def(py::init<const LobeParameters&>(), py::arg("lobe"), unlocked)
        .def("nu_rho", &nu_rho, py::arg("cos_o"), docs::LobeBandwidth_nu_rho)
        .def("at", &at, py::arg("wo"), py::arg("wi"), docs::LobeBandwidth_at);
    module.def("local_bandwidth", &local_bandwidth_of, py::arg("image"), py::arg("rule"), py::arg("quantile"),
               py::arg("epsilon"), py::arg("contrast"), py::arg("surround"));
}

}  // namespace burnish::python
