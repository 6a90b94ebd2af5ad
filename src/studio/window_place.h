// Where a window is put that was elsewhere before. Pure: no GLFW.
#pragma once
#include <optional>
#include <span>

namespace nullscope::viewer {

struct ScreenPlace {
    int x = 0, y = 0;  // of a window's left upper corner on the desktop, in the window system's coordinates
    friend bool operator==(const ScreenPlace&, const ScreenPlace&) = default;
};
struct ScreenArea {
    int x = 0, y = 0, width = 0, height = 0;
};

// The wished place, moved so that the window lies on the monitor that it covers most of, or that is nearest, as far as it fits there: its left
// upper corner is on it always. Nothing without monitors.
std::optional<ScreenPlace> visible_place(const ScreenArea& wished, std::span<const ScreenArea> monitors);

}  // namespace nullscope::viewer
