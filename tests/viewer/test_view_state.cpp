#include "studio/view_state.h"

#include <doctest/doctest.h>

#include "image/image_file.h"
#include "scene/bodies.h"
#include "scenefile/picture_scene.h"
#include "scenefile/scene_edit.h"
#include "studio/history.h"
#include "support/temporary_folder.h"

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

// A sphere of radius 2 among balls of radii 1, 0.9, 0.8 ..., apart from each other.
viewer::ViewState with_balls(int count) {
    viewer::ViewState view;
    REQUIRE(load_into(view, "sky-only"));
    for (int i = 0; i < count; ++i) {
        add(view.scene, BallSpec{.position = {6.0, 4.0 * i - 6.0, 0.0}, .radius = 1.0 - 0.1 * i});
        if (i == 0) add(view.scene, SphereSpec{.radius = 2.0});
    }
    auto good = savable(view.scene);
    REQUIRE(good);
    view.scene = std::move(*good);
    return view;
}

std::vector<double> drawn_balls(const viewer::ViewState& view) {
    std::vector<double> radii;
    for (const Body& body : viewer::drawn_scene(view).bodies)
        if (const auto* ball = std::get_if<BallSpec>(&body.shape)) radii.push_back(ball->radius);
    return radii;
}

bool draws_sphere(const viewer::ViewState& view) {
    return std::ranges::any_of(viewer::drawn_scene(view).bodies, has_shape<SphereSpec>);
}

using Radii = std::vector<double>;

TEST_CASE("view state: a picture is opened as the scene that it holds") {
    const TemporaryFolder folder("view-picture");
    const std::string file = (folder.path / "a.png").string();
    auto drawn = load_scene("kerr");
    REQUIRE(drawn);
    drawn->camera.r = 17.25;
    auto words = picture_words({*drawn, scene_folders("kerr")});
    REQUIRE(words);
    REQUIRE(save_png(file, Image<unsigned char>(4, 4, 3), *words));
    viewer::ViewState view;
    REQUIRE(load_into(view, file));
    CHECK(view.scene.camera.r == 17.25);
    CHECK(view.scene.name == drawn->name);
    CHECK(view.note.empty());
    REQUIRE(save_png(file, Image<unsigned char>(4, 4, 3)));
    CHECK_FALSE(load_into(view, file));
    CHECK(view.error.find("holds no scene") != std::string::npos);
}

TEST_CASE("view state: a hidden body is not drawn, and stays in the scene") {
    viewer::ViewState view = with_balls(3);
    const SectionRef second{"ball", 1, "ball[2]"};
    view.hidden.toggle(second);
    CHECK(drawn_balls(view) == Radii{1.0, 0.8});
    CHECK(draws_sphere(view));
    CHECK(view.scene.bodies.size() == 4);
    view.hidden.toggle({"sphere", 0, "sphere"});
    CHECK_FALSE(draws_sphere(view));
    CHECK(drawn_balls(view) == Radii{1.0, 0.8});
    view.hidden.toggle(second);
    CHECK(drawn_balls(view) == Radii{1.0, 0.9, 0.8});
    view.hidden.toggle(second);
    REQUIRE(load_into(view, "sky-only"));
    CHECK_FALSE(view.hidden.has(second));
}

TEST_CASE("view state: the same body stays hidden when others are added, removed and duplicated") {
    viewer::ViewState view = with_balls(3);
    const auto ball = [](std::size_t number) { return SectionRef{"ball", number, ""}; };
    const auto edit = [&](Result<Scene> edited) {
        REQUIRE(edited);
        view.scene = std::move(*edited);
    };
    view.hidden.toggle(ball(1));
    edit(with_section(view.scene, "cylinder"));
    edit(with_copy(view.scene, ball(0)));
    view.hidden.copied(ball(0));
    CHECK(drawn_balls(view) == Radii{1.0, 1.0, 0.8});
    edit(with_copy(view.scene, ball(2)));  // the hidden one: its copy is shown
    view.hidden.copied(ball(2));
    CHECK(drawn_balls(view) == Radii{1.0, 1.0, 0.9, 0.8});
    edit(without_section(view.scene, ball(0)));
    view.hidden.removed(ball(0));
    CHECK(drawn_balls(view) == Radii{1.0, 0.9, 0.8});
    edit(without_section(view.scene, ball(1)));  // the hidden one
    view.hidden.removed(ball(1));
    CHECK(drawn_balls(view) == Radii{1.0, 0.9, 0.8});
    edit(without_section(view.scene, {"sphere", 0, ""}));
    view.hidden.removed({"sphere", 0, ""});
    CHECK(drawn_balls(view) == Radii{1.0, 0.9, 0.8});
}

TEST_CASE("view state: undo and redo bring back which bodies are hidden; hiding alone is no step") {
    viewer::ViewState view = with_balls(3);
    viewer::History history;
    std::string what;
    history.rest(view);
    view.hidden.toggle({"ball", 1, ""});
    history.rest(view);
    view.scene = *without_section(view.scene, {"ball", 0, ""});
    view.hidden.removed({"ball", 0, ""});
    history.rest(view);
    CHECK(drawn_balls(view) == Radii{0.8});
    REQUIRE(history.undo(view, what));
    CHECK(drawn_balls(view) == Radii{1.0, 0.8});
    CHECK_FALSE(history.undo(view, what));
    REQUIRE(history.redo(view, what));
    CHECK(drawn_balls(view) == Radii{0.8});
}

}  // namespace
