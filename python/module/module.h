// The parts of the module nullscope._core: each adds its names.
#pragma once
#include <nanobind/nanobind.h>

#include <memory>
#include <string>

#include "command/session.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::python {

namespace nb = nanobind;

void add_scene(nb::module_& module);
void add_spacetime(nb::module_& module);
void add_observer(nb::module_& module);
void add_trace(nb::module_& module);
void add_picture(nb::module_& module);
void add_telescope(nb::module_& module);
void add_fit(nb::module_& module);

// An OpenGL context and what is in it, kept in this thread for the next picture.
Result<cli::Session*> session_of(const std::string& context);
// Closes what pictures keep in this thread: an OpenGL context and what is in it.
void forget_session();

// A metric with the words that it was made by.
struct Space {
    SpacetimeSpec spec;
    std::shared_ptr<const Spacetime> metric;
};
Space space_of(const SpacetimeSpec& spec);  // throws Refused
std::string pickled(
    const Scene& scene);  // text that parse_scene_in() reads beside the scenes that ship; throws Refused
Scene scene_of(const nb::object& given);  // what nullscope.scene() makes of it; throws as that does

}  // namespace nullscope::python
