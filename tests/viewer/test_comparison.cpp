#include "studio/comparison.h"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include "scene/bodies.h"
#include "scenefile/scene_edit.h"
#include "studio/history.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;

ViewState with_side_b() {
    ViewState view;
    view.scene.spacetime = {"kerr", {{"spin", 0.9}}};
    view.scene.disc.emplace();
    view.side_b = std::make_shared<SideB>(SideB{view.scene, view.method, view.off});
    return view;
}

std::pair<std::string, std::string> words_of(const ViewState& view) {
    return side_words({drawn_scene(view), {}}, {drawn_side_b(view), {}});
}

TEST_CASE("comparison: side B keeps its settings and has the view's camera and time") {
    ViewState view = with_side_b();
    view.scene.spacetime = {"schwarzschild", {}};
    view.scene.light.beaming = false;
    view.off.insert(Effect::kDisc);
    view.scene.camera.r = 33.0, view.scene.camera.width = 321;
    view.scene.time = 7.0;
    const Scene b = drawn_side_b(view);
    CHECK(b.spacetime == SpacetimeSpec{"kerr", {{"spin", 0.9}}});
    CHECK(b.light.beaming);
    CHECK(b.disc);
    CHECK(b.camera.r == 33.0);
    CHECK(b.camera.width == 321);
    CHECK(b.time == 7.0);
    CHECK(!drawn_scene(view).disc);
}

TEST_CASE("comparison: a body that is hidden is hidden on both sides, also where others have come or gone") {
    ViewState view = with_side_b();
    const auto radii = [](const Scene& scene) {
        std::vector<double> all;
        for (const Body& body : scene.bodies)
            if (const auto* ball = std::get_if<BallSpec>(&body.shape)) all.push_back(ball->radius);
        return all;
    };
    for (const double radius : {1.0, 0.9, 0.8}) add_body(view.scene, BallSpec{.radius = radius});
    view.side_b = std::make_shared<SideB>(SideB{view.scene, view.method, view.off});
    view.hidden.toggle({"ball", 1, ""});
    CHECK(radii(drawn_side_b(view)) == std::vector{1.0, 0.8});
    std::get<BallSpec>(view.scene.bodies[1].shape).radius = 0.5;  // the second on either side
    CHECK(radii(drawn_side_b(view)) == std::vector{1.0, 0.8});
    view.hidden.toggle({"ball", 1, ""});
    view.hidden.toggle({"ball", 2, ""});
    view.scene = *without_section(view.scene, {"ball", 0, ""});
    view.hidden.removed({"ball", 0, ""});
    CHECK(radii(drawn_scene(view)) == std::vector{0.5});
    CHECK(radii(drawn_side_b(view)) == std::vector{1.0, 0.9});
}

TEST_CASE("comparison: sides are swapped, and undo swaps them back") {
    ViewState view = with_side_b();
    view.sides = 2;
    History history;
    std::string what;
    history.rest(view);
    view.scene.disc->outer = 9.0, view.method.automatic = false;
    const double outer = view.side_b->scene.disc->outer;
    history.rest(view);
    view.scene.camera.r = 40.0;
    history.rest(view);
    swap_sides(view);
    CHECK(view.scene.disc->outer == outer);
    CHECK(view.side_b->scene.disc->outer == 9.0);
    CHECK(view.method.automatic);
    CHECK(!view.side_b->method.automatic);
    CHECK(view.scene.camera.r == 40.0);
    REQUIRE(history.undo(view, what));
    CHECK(what == "sides swapped");
    CHECK(view.scene.disc->outer == 9.0);
    CHECK(view.side_b->scene.disc->outer == outer);
    REQUIRE(history.redo(view, what));
    CHECK(view.scene.disc->outer == outer);
    CHECK(view.side_b->scene.disc->outer == 9.0);
    REQUIRE(history.undo(view, what));
    REQUIRE(history.undo(view, what));
    CHECK(view.scene.camera.r != 40.0);
    CHECK(view.side_b->scene.disc->outer == outer);
}

TEST_CASE("comparison: labels say what differs") {
    ViewState view = with_side_b();
    CHECK(words_of(view) == std::pair<std::string, std::string>{"A", "B"});
    view.scene.camera.r = 40.0, view.scene.time = 3.0;
    CHECK(words_of(view) == std::pair<std::string, std::string>{"A", "B"});
    view.scene.light.beaming = false;
    CHECK(words_of(view) == std::pair<std::string, std::string>{"A: Beaming off", "B: Beaming on"});
    view = with_side_b();
    view.scene.spacetime = {"schwarzschild", {}};
    CHECK(words_of(view).first == "A: Schwarzschild");
    CHECK(words_of(view).second.starts_with("B: Kerr"));
    view = with_side_b();
    view.scene.disc.reset();
    CHECK(words_of(view) == std::pair<std::string, std::string>{"A: without disc", "B: with disc"});
    view = with_side_b();
    view.scene.disc->outer = 9.0;
    CHECK(words_of(view) ==
          std::pair<std::string, std::string>{"A: disc.outer 9 r_s",
                                              "B: disc.outer " + fmt::format("{:.5g}", DiscSpec{}.outer) + " r_s"});
    view = with_side_b();
    Method table;
    table.kind = MethodKind::kTable;
    const auto methods = side_words({drawn_scene(view), table}, {drawn_side_b(view), {}});
    CHECK(methods.first.starts_with("A: table"));
    CHECK(methods.second.starts_with("B: strip"));
}

}  // namespace
