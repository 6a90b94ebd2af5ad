// A window that was elsewhere before comes back where it can be seen.
#include <doctest/doctest.h>

#include <array>

#include "studio/window_place.h"

namespace {

using namespace nullscope::viewer;

TEST_CASE("a window's place: kept where it is visible, else moved to the monitor that is nearest") {
    constexpr std::array kMonitors = {ScreenArea{0, 30, 1920, 1050}, ScreenArea{1920, 0, 1280, 1024}};
    const auto place = [&](int x, int y) { return visible_place({x, y, 800, 600}, kMonitors); };
    CHECK(place(100, 200) == ScreenPlace{100, 200});
    CHECK(place(2000, 100) == ScreenPlace{2000, 100});
    CHECK(place(-50, 0) == ScreenPlace{0, 30});          // below the first one's panel
    CHECK(place(1500, 900) == ScreenPlace{1120, 480});   // more of it was on the first
    CHECK(place(99999, 400) == ScreenPlace{2400, 400});  // of a monitor that is gone
    CHECK(place(-99999, -99999) == ScreenPlace{0, 30});
    CHECK(visible_place({500, 500, 5000, 4000}, kMonitors) == ScreenPlace{0, 30});  // larger than any
    CHECK(place(2147483647, 2147483647) == ScreenPlace{2400, 424});
    CHECK_FALSE(visible_place({0, 0, 800, 600}, {}));
}

}  // namespace
