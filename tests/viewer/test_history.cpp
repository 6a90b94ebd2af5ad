// Undo and redo in the viewer, and views as a line of text.
#include <doctest/doctest.h>

#include "scene/bodies.h"
#include "scenefile/scene_text.h"
#include "scenefile/scene_writer.h"
#include "studio/comparison.h"
#include "studio/history.h"

namespace {

using namespace nullscope;
using viewer::copied_view;
using viewer::History;
using viewer::is_as_shipped;
using viewer::is_view;
using viewer::scene_of_view;
using viewer::SideB;
using viewer::swap_sides;
using viewer::ViewState;

ViewState opened(const char* name) {
    ViewState view;
    view.shipped = shipped_scenes();
    REQUIRE(load_into(view, name));
    return view;
}

TEST_CASE("history: moves of the camera are one step, and an edit before them is the second") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    CHECK_FALSE(history.undo(view, what));
    const CameraSpec home = view.scene.camera;
    view.scene.sky.brightness *= 2.0;
    history.rest(view);
    for (const double r : {30.0, 40.0, 50.0}) {
        view.scene.camera.r = r, view.scene.camera.yaw += 0.1, view.scene.time += 1.0;
        history.rest(view);
        history.rest(view);
    }
    REQUIRE(history.undo(view, what));
    CHECK(what == "camera");
    CHECK(view.scene.camera.r == home.r);
    CHECK(view.scene.time == 0.0);
    REQUIRE(history.undo(view, what));
    CHECK(what == "sky.brightness");
    REQUIRE(history.redo(view, what));
    REQUIRE(history.redo(view, what));
    CHECK(view.scene.camera.r == 50.0);
    CHECK_FALSE(history.redo(view, what));
    view.scene.camera.r = 60.0;  // the same flight goes on
    REQUIRE(history.undo(view, what));
    CHECK(view.scene.camera.r == home.r);
    REQUIRE(history.undo(view, what));
    CHECK_FALSE(history.undo(view, what));
}

TEST_CASE("history: a command that puts the camera elsewhere is a step by itself, between the moves") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    view.scene.camera.r = 30.0;
    history.rest(view);
    view.scene.camera.r = 40.0;
    ++view.jumps;
    history.rest(view);
    view.scene.camera.r = 50.0;
    history.rest(view);
    view.scene.camera.exposure_ev = 1.0;  // no move
    for (const double r : {50.0, 40.0, 30.0}) {
        REQUIRE(history.undo(view, what));
        CHECK(view.scene.camera.r == r);
    }
}

TEST_CASE("history: each edit is a step back and forward, and what was undone is forgotten by a new step") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    const double home = view.scene.sky.brightness;
    for (const double brightness : {3.0, 4.0, 5.0}) {
        view.scene.sky.brightness = brightness;
        history.rest(view);
        history.rest(view);  // no step
    }
    REQUIRE(history.undo(view, what));
    CHECK(what == "sky.brightness");
    CHECK(view.scene.sky.brightness == 4.0);
    REQUIRE(history.undo(view, what));
    REQUIRE(history.undo(view, what));
    CHECK(view.scene.sky.brightness == home);
    CHECK_FALSE(history.undo(view, what));
    REQUIRE(history.redo(view, what));
    CHECK(view.scene.sky.brightness == 3.0);
    view.scene.disc->brightness *= 2.0;
    view.scene.sky.brightness *= 2.0;
    REQUIRE(history.undo(view, what));  // without a rest before
    CHECK(what == "disc.brightness, sky.brightness");
    CHECK(view.scene.sky.brightness == 3.0);
    REQUIRE(history.redo(view, what));
    CHECK_FALSE(history.redo(view, what));  // 4 and 5 are gone
    view.scene.disc.reset();
    REQUIRE(history.undo(view, what));
    CHECK(what == "disc removed");
    REQUIRE(history.redo(view, what));
    CHECK(what == "disc removed");
}

TEST_CASE("history: another scene is a step, the window's size is none") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    view.scene.camera.width += 100;
    history.rest(view);
    CHECK_FALSE(history.undo(view, what));
    const int width = view.scene.camera.width;
    REQUIRE(load_into(view, "kerr"));
    view.scene.camera.width = width;
    history.rest(view);
    REQUIRE(history.undo(view, what));
    CHECK(what == "another scene");
    CHECK(view.source == "first-light");
    CHECK(view.scene.spacetime.metric == "schwarzschild");
    CHECK(view.scene.camera.width == width);
}

TEST_CASE("history: a save is no step, and what was done before it is undone in the saved file") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    REQUIRE(load_into(view, "kerr"));
    history.rest(view);
    const double brightness = view.scene.sky.brightness;
    view.scene.sky.brightness *= 2.0;
    history.rest(view);
    history.saved(view.source, "/tmp/kerr.toml");
    view.source = "/tmp/kerr.toml", view.loaded = view.scene;
    history.rest(view);
    REQUIRE(history.undo(view, what));
    CHECK(what == "sky.brightness");
    CHECK(view.scene.sky.brightness == brightness);
    CHECK(view.source == "/tmp/kerr.toml");
    REQUIRE(history.undo(view, what));
    CHECK(what == "another scene");
    CHECK(view.source == "first-light");
}

TEST_CASE("history: steps of a tour are undone with what they switch off, and R returns to their view") {
    ViewState view = opened("first-light");
    view.own = {"mine.toml"};
    History history;
    std::string what;
    history.rest(view);
    CameraSpec camera = view.scene.camera;
    camera.r = 40.0;
    REQUIRE(load_step(view, {"first-light", camera, {Effect::kDisc}, ""}));
    history.rest(view);
    REQUIRE(load_step(view, {"first-light", camera, {}, ""}));
    history.rest(view);
    CHECK_FALSE(load_step(view, {"no-such-scene", {}, {}, ""}));
    REQUIRE(history.undo(view, what));
    CHECK(what == "effect disc switched on");
    CHECK(view.off == EffectSet{Effect::kDisc});
    CHECK(view.scene.camera.r == 40.0);
    view.scene.camera.r = 9.0;
    reset_camera(view);
    CHECK(view.scene.camera.r == 40.0);
    REQUIRE(history.undo(view, what));
    CHECK(view.off.empty());
    CHECK(view.scene.camera.r == view.loaded.camera.r);
    CHECK(view.own == std::vector<std::string>{"mine.toml"});
}

void compare_sides(ViewState& view) {
    view.side_b = std::make_shared<SideB>(SideB{view.scene, view.method, view.off});
    view.sides = 2;
}

TEST_CASE("history: effects, the method and sides that are swapped are steps with names") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    compare_sides(view);
    history.rest(view);
    view.off = {Effect::kDisc};
    history.rest(view);
    view.method.automatic = false;
    history.rest(view);
    swap_sides(view);
    history.rest(view);
    CHECK(view.off.empty());
    for (const char* words : {"sides swapped", "method", "effect disc switched off"}) {
        REQUIRE(history.undo(view, what));
        CHECK(what == words);
    }
    CHECK(view.method.automatic);
    CHECK_FALSE(history.undo(view, what));
    REQUIRE(history.redo(view, what));
    CHECK(what == "effect disc switched off");
    CHECK(view.off == EffectSet{Effect::kDisc});
}

TEST_CASE("history: two sides that were alike, swapped in a comparison that has ended, are named") {
    ViewState view = opened("first-light");
    History history;
    std::string what;
    history.rest(view);
    compare_sides(view);
    history.rest(view);
    swap_sides(view);
    history.rest(view);
    view.side_b.reset();
    view.sides = 4;
    history.rest(view);
    REQUIRE(history.undo(view, what));
    CHECK(what == "sides swapped");
}

TEST_CASE("views: what is copied in one scene is pasted into another, and other text is refused") {
    ViewState from = opened("first-light"), to = opened("sky-only");
    const CameraSpec before = to.scene.camera;
    CHECK_FALSE(paste_view(to, ""));
    CHECK_FALSE(paste_view(to, "https://example.org"));
    CHECK_FALSE(paste_view(to, "camera = { r = -3 }"));
    CHECK(view_line(to.scene.camera) == view_line(before));
    REQUIRE(paste_view(to, view_line(from.scene.camera) + "\n"));
    CHECK(view_line(to.scene.camera) == view_line(from.scene.camera));
    CHECK(to.scene.camera.width == before.width);
}

TEST_CASE("views: a copied line is a view that says its scene, and is pasted with it") {
    ViewState from = opened("first-light"), to = opened("sky-only");
    from.scene.camera.yaw = 0.25;
    const std::string line = copied_view(from);
    CHECK(line.find('\n') == std::string::npos);
    CHECK(is_view(line));
    CHECK_FALSE(is_view("kerr.toml"));
    CHECK(scene_of_view(line) == "First light");
    CHECK(scene_of_view(line + "\r\nmore") == "First light");
    CHECK(scene_of_view(view_line(from.scene.camera)).empty());
    REQUIRE(paste_view(to, line));
    CHECK(view_line(to.scene.camera) == view_line(from.scene.camera));
}

TEST_CASE("views: of a scene that was changed the copied line is all of it") {
    ViewState from = opened("first-light");
    CHECK(is_as_shipped(from));
    add_body(from.scene, BallSpec{.position = {5, 1, 2}, .radius = 0.5});
    CHECK_FALSE(is_as_shipped(from));
    const std::string line = copied_view(from);
    CHECK(line.find('\n') == std::string::npos);
    CHECK(is_view(line));
    CHECK(is_scene_line(line));
    auto again = scene_of_line(line + "\nmore");
    REQUIRE_MESSAGE(again, again.error().message());
    set_size(*again, from.scene.camera.width, from.scene.camera.height);
    const auto one = scene_lines(from.scene), other = scene_lines(*again);
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].name + one[i].value == other[i].name + other[i].value);
    CHECK_FALSE(scene_of_line("scene = { camera = { r = -3 } }"));
    CHECK_FALSE(scene_of_line("scene = 3"));
}

}  // namespace
