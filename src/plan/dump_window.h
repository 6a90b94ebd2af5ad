// Slow light: which of a simulation's dumps a picture shows, where each place is seen at the time when its light left.
//
// Dumps are of one time each, of the clock of their coordinates: t of Boyer and Lindquist, or that of Kerr and Schild, v - r, which is ahead of
// t by time_ahead(r) (spacetime/tortoise.h). Of the matter within `outer` the last that is seen is its near side, whose light comes straight
// outward, along t - r_*. The first is its far side: its light went round the hole, through 2.7 pi, for kRound longer than r_* of both ends.
// What went round more often, and what left next to the horizon, is fainter than a thousandth; it shows the first of these dumps.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/medium_dumps.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

class Spacetime;

inline constexpr double kRound = 15.0;  // r_s/c
inline constexpr std::size_t kMostDumpBytes = std::size_t{896} << 20;

// By how much the dumps' clock is behind Scene::time where the last and where the first light left, r_s/c. Both 0 where light.delay is off.
struct DumpDelays {
    double least, greatest;
};
DumpDelays dump_delays(const Spacetime& spacetime, const Scene& scene, const MediumGrid& form);

// Dumps counted from the first of the series, all that are seen; slots: that a texture has for them, as long as the camera's radius and the
// matter's are the same.
struct DumpWindow {
    int first, last, slots;
    int count() const { return last - first + 1; }
};
DumpWindow dump_window(const Spacetime& spacetime, const Scene& scene, const MediumGrid& form);
std::string window_words(const Spacetime& spacetime, const Scene& scene, const MediumGrid& form);

// Files of the dumps that are seen at a time; of slow light along a path, which changes the delays, all of them.
std::vector<std::filesystem::path> dumps_seen(const Scene& scene, double time);

// Scene times that can be drawn: of a scene with dumps. Empty, from > to: of slow light, whose dumps are of a shorter time than is seen.
DumpTimes medium_times(const Spacetime& spacetime, const Scene& scene);
DumpTimes medium_times(const Scene& scene);
// A time that cannot be drawn; dumps of which more are seen than kMostDumpBytes hold.
std::optional<SceneFault> medium_time_fault(const Spacetime& spacetime, const Scene& scene, double time);
std::optional<SceneFault> medium_time_fault(const Scene& scene, double time);

}  // namespace nullscope
