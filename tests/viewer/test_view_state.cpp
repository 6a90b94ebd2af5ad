#include "viewer/view_state.h"

#include <doctest/doctest.h>

#include "scene/bodies.h"

namespace {

using namespace nullscope;

TEST_CASE("view state: without lensing a hole is a black sphere as large as its horizon") {
    viewer::ViewState view;
    view.scene.spacetime.metric = "schwarzschild";
    view.scene.camera.r = 20.0;
    CHECK(viewer::drawn_scene(view).bodies.empty());
    view.scene.light.lensing = false;
    const Scene drawn = viewer::drawn_scene(view);
    REQUIRE(drawn.bodies.size() == 1);
    CHECK(first_shape<SphereSpec>(drawn)->radius == doctest::Approx(1.001));
    CHECK(drawn.bodies.front().material.colour == Vec3{0, 0, 0});
    CHECK(view.scene.bodies.empty());  // what is saved
    view.scene.camera.r = 1.0005;
    CHECK(viewer::drawn_scene(view).bodies.empty());
    view.scene.camera.r = 20.0;
    view.scene.spacetime = {"kerr", {{"spin", 0.9}}};
    CHECK(viewer::drawn_scene(view).bodies.empty());
    view.scene.spacetime = {"minkowski", {}};
    CHECK(viewer::drawn_scene(view).bodies.empty());
}

}  // namespace
