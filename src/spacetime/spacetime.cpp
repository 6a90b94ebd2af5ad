#include "spacetime/spacetime.h"

#include <fmt/format.h>

namespace nullscope {

namespace {
bool within(RadiusRange range, double r) { return r > range.low && r < range.high; }
std::string in_words(RadiusRange range) {
    return range.high < kAnyRadius ? fmt::format("{} < r < {}", range.low, range.high)
                                   : fmt::format("r > {}", range.low);
}
}  // namespace

bool camera_can_rest(const Spacetime& spacetime, double r) { return within(spacetime.camera_range(), r); }
bool camera_can_be(const Spacetime& spacetime, double r) { return within(spacetime.falling_range(), r); }
std::string allowed_radii(const Spacetime& spacetime) { return in_words(spacetime.camera_range()); }
std::string allowed_falling_radii(const Spacetime& spacetime) { return in_words(spacetime.falling_range()); }

}  // namespace nullscope
