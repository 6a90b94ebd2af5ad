#include "plan/dump_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observer/observer.h"
#include "plan/medium.h"
#include "spacetime/registry.h"
#include "spacetime/tortoise.h"

namespace nullscope {
namespace {

constexpr double kSame = 1e-9;  // of dumps: a time on one is not between two

bool is_slow(const Scene& scene) { return has_slow_light(scene) && scene.light.delay; }

double in_dumps(const GridMatter& grid, double time) { return (time - grid.start) / grid.cadence; }

int slots_of(const GridMatter& grid, const DumpDelays& delays) {
    const double span = std::ceil((delays.greatest - delays.least) / grid.cadence - kSame) + 2.0;
    return static_cast<int>(std::min(span, grid.last - grid.first + 1.0));
}

}  // namespace

DumpDelays dump_delays(const Spacetime& spacetime, const Scene& scene, const MediumGrid& form) {
    constexpr double kNearHole = 1.5;  // r_s: closer to it light takes no longer for going in and out
    if (!is_slow(scene)) return {0.0, 0.0};
    const double camera = scene.camera.r, outer = scene.medium->outer;
    const auto hole = medium_hole(spacetime);
    if (!hole || !(hole->outer > 0.0)) return {std::max(camera - outer, 0.0), camera + outer};
    const double above = hole->outer + kMediumAboveHorizon;
    const auto ahead = [&](double r) { return time_ahead(spacetime, std::max(r, above)); };
    const auto tortoise = [&](double r) { return std::max(r, above) + ahead(r); };
    const auto by_dumps = [&](double r) { return form.kerr_schild() ? ahead(r) : 0.0; };
    // v of the camera, by its clock.
    const double v = camera + (falls(scene.camera) ? 0.0 : ahead(camera));
    const double out = 2.0 * std::max(tortoise(std::max(camera, kNearHole)), 0.0);  // v - u, where it is far enough
    const double last = camera > outer ? v - 2.0 * tortoise(camera) + tortoise(outer) + by_dumps(outer)
                                       : v - tortoise(camera) + by_dumps(camera),
                 first = v - out - tortoise(outer) - kRound + by_dumps(outer);
    return {-last, -first};
}

DumpWindow dump_window(const Spacetime& spacetime, const Scene& scene, const MediumGrid& form) {
    const GridMatter& grid = scene.medium->grid;
    const DumpDelays delays = dump_delays(spacetime, scene, form);
    const int most = grid.last - grid.first;
    const auto clamped = [&](double dump) {
        return static_cast<int>(std::clamp(dump, 0.0, static_cast<double>(most)));
    };
    return {clamped(std::floor(in_dumps(grid, scene.time - delays.greatest) + kSame)),
            clamped(std::ceil(in_dumps(grid, scene.time - delays.least) - kSame)), slots_of(grid, delays)};
}

std::string window_words(const Spacetime& spacetime, const Scene& scene, const MediumGrid& form) {
    const GridMatter& grid = scene.medium->grid;
    const DumpDelays delays = dump_delays(spacetime, scene, form);
    const DumpWindow window = dump_window(spacetime, scene, form);
    return fmt::format("{}: {} to {}, whose light left {:.4g} to {:.4g} r_s/c before", dump_words(grid),
                       grid.first + window.first, grid.first + window.last, delays.least, delays.greatest);
}

std::vector<std::filesystem::path> dumps_seen(const Scene& scene, double time) {
    const GridMatter& grid = scene.medium->grid;
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (!is_slow(scene) || !spacetime) return dumps_about(grid, time);
    DumpWindow window{0, grid.last - grid.first, 0};
    if (const auto form = medium_form(scene); form && !scene.path) {
        Scene then = scene;
        then.time = time;
        window = dump_window(**spacetime, then, *form);
    }
    std::vector<std::filesystem::path> files;
    for (int dump = window.first; dump <= window.last; ++dump)
        files.push_back(dumps_about(grid, grid.start + dump * grid.cadence).front());
    return files;
}

DumpTimes medium_times(const Spacetime& spacetime, const Scene& scene) {
    DumpTimes times = dump_times(scene.medium->grid);
    if (!is_slow(scene)) return times;
    const auto form = medium_form(scene);
    if (!form) return times;  // which dump_fault() says
    const DumpDelays delays = dump_delays(spacetime, scene, *form);
    return {times.from + delays.greatest, times.to + delays.least};
}

DumpTimes medium_times(const Scene& scene) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    return spacetime ? medium_times(**spacetime, scene) : dump_times(scene.medium->grid);
}

std::optional<SceneFault> medium_time_fault(const Spacetime& spacetime, const Scene& scene, double time) {
    const GridMatter& grid = scene.medium->grid;
    if (!is_slow(scene)) return dump_time_fault(grid, time);
    const auto form = medium_form(scene);
    if (!form) return file_fault("medium.file", grid.file, form.error(), "a grid of matter");
    const DumpDelays delays = dump_delays(spacetime, scene, *form);
    const int slots = slots_of(grid, delays);
    const auto most = static_cast<int>(kMostDumpBytes / form->bytes());
    if (slots > most)
        return SceneFault{"medium.light",
                          fmt::format("a picture shows {} dumps of {:.0f} MiB", slots,
                                      static_cast<double>(form->bytes()) / (1 << 20)),
                          fmt::format("at most {}: a longer cadence, fewer nodes, a smaller outer, or fast", most),
                          "medium.file"};
    const auto [from, to] = medium_times(spacetime, scene);
    if (from > to)
        return SceneFault{
            "medium.light",
            fmt::format("the light that a picture shows left within {:.9g} r_s/c, all dumps of {} within {:.9g}",
                        delays.greatest - delays.least, "medium.file", (grid.last - grid.first) * grid.cadence),
            "more dumps, a smaller outer, or fast", "medium.file"};
    const double rounding = kSame * grid.cadence * std::max(1.0, std::abs(in_dumps(grid, time)));
    if (time >= from - rounding && time <= to + rounding) return std::nullopt;
    return SceneFault{
        "time", fmt::format("{:.9g}: the light of then left outside of the times of the dumps of medium.file", time),
        fmt::format("[{:.9g}, {:.9g}] r_s/c, of dumps {} to {} seen {:.9g} to {:.9g} r_s/c later", from, to, grid.first,
                    grid.last, delays.least, delays.greatest),
        "medium.file"};
}

std::optional<SceneFault> medium_time_fault(const Scene& scene, double time) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    return spacetime ? medium_time_fault(**spacetime, scene, time) : std::nullopt;
}

}  // namespace nullscope
