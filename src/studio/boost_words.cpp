#include "studio/boost_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace nullscope::viewer {
namespace {

const char* observer_words(ObserverKind observer) {
    switch (observer) {
        case ObserverKind::kRain: return "who fell from rest at infinity";
        case ObserverKind::kFall: return "who fell from rest at r = fall_from";
        case ObserverKind::kThrow: return "who falls with the scene's energy";
        case ObserverKind::kOrbit:
        case ObserverKind::kCounterOrbit: return "on the circular orbit here";
        case ObserverKind::kZamo: return "without angular momentum here";
        case ObserverKind::kCarter: return "of Carter's frame here";
        default: return "at rest here";
    }
}

}  // namespace

std::string boost_words(const CameraSpec& camera) {
    constexpr double kNamed = 0.1;  // of the speed
    const Vec3& velocity = camera.velocity;
    std::array<std::pair<double, const char*>, 3> parts = {{{velocity.x, velocity.x < 0.0 ? "inward" : "outward"},
                                                            {velocity.y, velocity.y < 0.0 ? "north" : "south"},
                                                            {velocity.z, velocity.z < 0.0 ? "west" : "east"}}};
    std::ranges::stable_sort(parts, std::greater(), [](const auto& part) { return std::fabs(part.first); });
    const double speed = length(velocity);
    std::string words = speed > 0.0 ? fmt::format("{:.4g} c", speed) : "at rest";
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (std::fabs(parts[i].first) > kNamed * speed)
            words += fmt::format("{}{}", i == 0 ? ", " : " and ", parts[i].second);
    return words + fmt::format(", relative to an observer {}", observer_words(camera.observer));
}

}  // namespace nullscope::viewer
