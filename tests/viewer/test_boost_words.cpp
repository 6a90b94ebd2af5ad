// A boost in words.
#include <doctest/doctest.h>

#include "studio/boost_words.h"

namespace {

using namespace nullscope;

TEST_CASE("boost words: speed, directions and the observer") {
    const auto words = [](Vec3 velocity, ObserverKind observer) {
        CameraSpec camera;
        camera.velocity = velocity, camera.observer = observer;
        return viewer::boost_words(camera);
    };
    CHECK(words({0.5, 0, 0}, ObserverKind::kStatic) == "0.5 c, outward, relative to an observer at rest here");
    CHECK(words({0.5, 0, 0}, ObserverKind::kRain) ==
          "0.5 c, outward, relative to an observer who fell from rest at infinity");
    CHECK(words({}, ObserverKind::kRain) == "at rest, relative to an observer who fell from rest at infinity");
    CHECK(words({-0.3, 0.01, 0.4}, ObserverKind::kZamo) ==
          "0.5001 c, east and inward, relative to an observer without angular momentum here");
    CHECK(words({0, -0.2, 0}, ObserverKind::kOrbit) ==
          "0.2 c, north, relative to an observer on the circular orbit here");
}

}  // namespace
