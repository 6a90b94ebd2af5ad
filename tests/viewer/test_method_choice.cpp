// The method that the panel's wish comes to, and its words.
#include <doctest/doctest.h>

#include "base/assets.h"
#include "studio/method_choice.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;

Method method_of(const char* name) { return *parse_method(name); }

TEST_CASE("method: the wish comes to what capture --method auto would take, refused in words") {
    const std::vector<MeasuredMethod> measured = {{"schwarzschild", method_of("strip"), 0.01, 2.0},
                                                  {"schwarzschild", method_of("table:64:cubic"), 0.001, 3.0},
                                                  {"schwarzschild", method_of("euler:100"), 100.0, 6.0}};
    Scene scene;
    scene.camera.width = 3840;
    scene.camera.plane_width = 2e-3;  // a pixel is a thousandth of the bench's: all errors count thousandfold
    CHECK(error_in_frame(measured[0], scene) == doctest::Approx(10).epsilon(1e-4));
    MethodWish wish;
    wish.max_error_px = 20;
    CHECK(method_choice(measured, wish, scene).method == method_of("strip"));
    wish.max_error_px = 5;
    const MethodChoice dearer = method_choice(measured, wish, scene);
    CHECK(dearer.method == method_of("table:64:cubic"));
    CHECK(dearer.kept);
    CHECK(dearer.method == choose_method(measured, scene, 5)->method);
    wish.max_error_px = 0.5;
    const MethodChoice refused = method_choice(measured, wish, scene);
    CHECK(!refused.kept);
    CHECK(refused.method == method_of("table:64:cubic"));
    CHECK(refused.words.find("The lowest error, 1 px, is that of") != std::string::npos);
    wish.automatic = false;
    wish.method = method_of("euler:100");
    CHECK(method_choice(measured, wish, scene).method == method_of("euler:100"));
    CHECK(!method_choice(measured, wish, scene).kept);
    wish.method = method_of("euler:300");
    CHECK(method_choice(measured, wish, scene).words.find("not measured") != std::string::npos);
    scene.spacetime.metric = "minkowski";
    wish.automatic = true;
    CHECK(method_choice(measured, wish, scene).method == Method{});
    CHECK(method_choice({}, wish, scene).kept);
}

TEST_CASE("method: next to the ring of a rotating hole its own bounds are told") {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", 0.9}}};
    scene.camera.observer = ObserverKind::kZamo;
    scene.camera.zoom.emplace().depth = 5;
    MethodWish wish;
    const MethodChoice kept = method_choice({}, wish, scene);
    CHECK(kept.kept);
    CHECK(kept.words.find("at most 0.05 px across") != std::string::npos);
    wish.max_error_px = 0.01;
    CHECK(!method_choice({}, wish, scene).kept);
    wish = {};
    scene.spacetime.parameters["spin"] = 0.9995;
    const MethodChoice hard = method_choice({}, wish, scene);
    CHECK(!hard.kept);
    CHECK(hard.words.find("at most 0.5 px across") != std::string::npos);
}

TEST_CASE("method: dominated is what another beats in one and equals in the other") {
    const std::vector<MeasuredMethod> measured = {{"a", method_of("strip"), 0.01, 2.0},
                                                  {"a", method_of("closed-form"), 0.01, 3.0},
                                                  {"a", method_of("table"), 0.001, 3.0},
                                                  {"b", method_of("table"), 1.0, 9.0}};
    CHECK(!is_dominated(measured[0], measured));
    CHECK(is_dominated(measured[1], measured));
    CHECK(!is_dominated(measured[2], measured));
    CHECK(!is_dominated(measured[3], measured));
    CHECK(most_exact(measured, "a")->method == method_of("table"));
    CHECK(most_exact(measured, "c") == nullptr);
    const auto shipped = load_frontier(assets_directory() / "frontier.csv");
    REQUIRE(shipped);
    CHECK(most_exact(*shipped, "schwarzschild")->method == Method{});
}

}  // namespace
