#include "studio/window_place.h"

#include <algorithm>
#include <utility>

namespace nullscope::viewer {
namespace {

// How much both have in common; below 0: minus the distance.
long overlap(int low, int size, int other, int other_size) {
    return std::min<long>(static_cast<long>(low) + size, static_cast<long>(other) + other_size) - std::max(low, other);
}

// What a window covers of a monitor; of monitors that it misses the nearest is the best.
long long shared(const ScreenArea& window, const ScreenArea& monitor) {
    const long across = overlap(window.x, window.width, monitor.x, monitor.width),
               down = overlap(window.y, window.height, monitor.y, monitor.height);
    if (std::min(across, down) > 0) return static_cast<long long>(across) * down;
    return std::min(across, 0L) + std::min(down, 0L);
}

int moved_inside(int low, int size, int from, int room) { return std::max(std::min(low, from + room - size), from); }

}  // namespace

std::optional<ScreenPlace> visible_place(const ScreenArea& wished, std::span<const ScreenArea> monitors) {
    const auto best =
        std::ranges::max_element(monitors, {}, [&](const ScreenArea& monitor) { return shared(wished, monitor); });
    if (best == monitors.end()) return std::nullopt;
    return ScreenPlace{moved_inside(wished.x, wished.width, best->x, best->width),
                       moved_inside(wished.y, wished.height, best->y, best->height)};
}

}  // namespace nullscope::viewer
