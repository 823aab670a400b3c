// burnish._core: conversions between Python and libburnish, no maths. The public package is burnish/__init__.py.
#include "bind.h"

#include <burnish/job/run.h>

PYBIND11_MODULE(_core, module) {
    using namespace burnish::python;
    module.doc() = "Compiled part of burnish; import burnish instead.";
    module.attr("__version__") = std::string(burnish::version());
    bind_errors(module);
    bind_tables(module);
    bind_material(module);
    bind_measured(module);
    bind_light(module);
    bind_bandwidth(module);
    bind_frame(module);
    bind_job(module);
    bind_fit(module);
    bind_factor(module);
    bind_files(module);
    bind_preview(module);
    bind_shot(module);
}
