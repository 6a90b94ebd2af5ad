// nullscope._core, what the Python package is made of. Shapes, units and examples: nullscope/__init__.py and docs/python.md.
#include "module/module.h"

#include <nanobind/stl/string.h>

#include "base/assets.h"
#include "module/call.h"

NB_MODULE(_core, m) {
    using namespace nullscope;
    using namespace nullscope::python;
    m.doc() = "The compiled part of nullscope.";
    nb::set_leak_warnings(false);  // JAX keeps what its callbacks hold beyond the end
    m.attr("__version__") = NULLSCOPE_VERSION;
    nb::exception<Refused>(m, "Error", PyExc_ValueError).attr("__doc__") =
        "Bad input, or what could not be done: one line, as the command line says it.";
    m.def(
        "ship_assets", [](const std::string& folder) { ship_assets(folder); }, nb::arg("folder"),
        "Where scenes and sky data are; once, before anything else.");
    add_scene(m);
    add_spacetime(m);
    add_observer(m);
    add_trace(m);
    add_picture(m);
    add_telescope(m);
    add_fit(m);
}
