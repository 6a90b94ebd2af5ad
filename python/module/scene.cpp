#include <fmt/format.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "base/assets.h"
#include "module/call.h"
#include "module/module.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"

namespace nullscope::python {
namespace {

// Of text that is no file: an error has no line, which nobody wrote.
Scene parsed(const std::string& text, bool lines) {
    auto scene = parse_scene_in({".", assets_directory() / "scenes"}, text, "scene");
    if (scene) return std::move(*scene);
    Error error = scene.error();
    if (!lines) error.line = 0;
    throw Refused(error);
}

void unpickle(Scene& scene, const std::string& text) {
    new (&scene) Scene(value_of(parse_scene_in({assets_directory() / "scenes"}, text, "pickled scene")));
}

}  // namespace

// Files that ship are relative to where they ship, others absolute.
std::string pickled(const Scene& scene) {
    std::string text = exact_scene_text(scene, assets_directory() / "scenes");
    if (text.size() > kLargestSceneFile)
        throw Refused(bad_input(fmt::format("a scene of {} bytes cannot be pickled", text.size()),
                                fmt::format("{} bytes", kLargestSceneFile)));
    return text;
}

Scene scene_of(const nb::object& given) {
    return nb::cast<Scene>(nb::module_::import_("nullscope").attr("scene")(given));
}

void add_scene(nb::module_& m) {
    nb::class_<Scene>(m, "Scene", "A scene that was read and checked; nullscope.scene() makes it. Cannot be changed.")
        .def_ro("name", &Scene::name, "Its title.")
        .def_ro("description", &Scene::description, "One sentence.")
        .def_prop_ro(
            "size", [](const Scene& s) { return std::pair(s.camera.width, s.camera.height); },
            "Width and height of its picture, px.")
        .def_prop_ro(
            "text", [](const Scene& s) { return scene_file_text(s, {}); },
            "The text of a scene file that says the same (docs/scenes.md).")
        .def("__repr__", [](const Scene& s) { return "<nullscope.Scene " + s.name + ">"; })
        .def(
            "__eq__", [](const Scene& a, const Scene& b) { return scene_file_text(a, {}) == scene_file_text(b, {}); },
            nb::is_operator())
        .def("__getstate__", pickled)
        .def("__setstate__", unpickle)
        .def("__hash__", [](const Scene& s) { return std::hash<std::string>()(scene_file_text(s, {})); });
    m.def(
        "load_scene",
        [](const std::string& name) {
            std::vector<std::string> notes;
            Scene scene = value_of(load_scene(name, [&](const std::string& line) { notes.push_back(line); }));
            for (const std::string& note : notes)
                if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw nb::python_error();
            return scene;
        },
        nb::arg("file_or_name"), "A scene by its file, a picture that holds it, or the name of one that ships.");
    m.def("parse_scene", parsed, nb::arg("text"), nb::arg("lines") = true,
          "A scene by the text of its file. lines: whether an error says the line.");
    m.def(
        "scenes",
        [] {
            std::vector<std::string> names;
            for (const SceneInfo& info : shipped_scenes()) names.push_back(info.name);
            return names;
        },
        "The names of the scenes that ship, sorted.");
}

}  // namespace nullscope::python
