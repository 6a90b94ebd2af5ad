// Matter of a simulation's dumps: files of the same nodes (scene/medium_grid.h), which a number in their names tells apart, at equal steps of
// time. Between two of them each number of a node is linear in time, of those that MediumGrid::numbers() has: of density and temperature
// the logarithms. With fast light the whole picture is of one time, the scene's; with slow light each place is of the time when its light
// left (plan/dump_window.h).
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/medium_grid.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

bool has_dumps(const GridMatter& grid);
bool has_dumps(const Scene& scene);
bool has_slow_light(const Scene& scene);  // dumps whose light takes its time

// Numbers below 0: those of the folder, where it has any.
void settle_dumps(GridMatter& grid);

// Of the first and the last dump, r_s/c.
struct DumpTimes {
    double from, to;
};
DumpTimes dump_times(const GridMatter& grid);
std::string dump_words(const GridMatter& grid);  // "12 dumps, 0 to 11, at times [0, 5.5] r_s/c"

// A file that is missing, a dump of other nodes than the first one, a head that is none. Heads are read once for as long as a file does not
// change, files looked for when the folder does.
std::optional<SceneFault> dump_fault(const GridMatter& grid);
std::optional<SceneFault> dump_time_fault(const GridMatter& grid, double time);

// The dumps about a time, one or two; the nearest one outside of their times.
std::vector<std::filesystem::path> dumps_about(const GridMatter& grid, double time);

// The matter at a time: that of the file, or of the dumps. At a dump's own time, within 1e-9 of the time between two, that dump's. The dumps
// about the time that was asked for last are kept, and what is between them; of two scenes with dumps each its own. Thread-safe.
Result<std::shared_ptr<const MediumGrid>> medium_grid_at(const GridMatter& grid, double time);
Result<std::shared_ptr<const MediumGrid>> medium_grid_at(const Scene& scene);  // which has such a medium

// Without numbers: of slow light the first dump's head, else medium_grid_at()'s.
Result<MediumGrid> medium_form(const Scene& scene);

// One dump, counted from the first, of these nodes; nothing is kept.
Result<MediumGrid> read_medium_dump(const GridMatter& grid, int dump, const MediumGrid& form);

// A dump, counted from the first, as its file is now.
struct DumpStamp {
    int dump;
    std::filesystem::file_time_type time;
    std::uintmax_t size;
    friend bool operator==(const DumpStamp&, const DumpStamp&) = default;
};
DumpStamp dump_stamp(const GridMatter& grid, int dump);

// The dumps from one to another, both counted from the first. Those that were asked for last are kept. Thread-safe.
using MediumGrids = std::vector<std::shared_ptr<const MediumGrid>>;
Result<std::shared_ptr<const MediumGrids>> medium_grids(const GridMatter& grid, int from, int to);

long long dumps_read();  // by this process, for tests

// Of the dumps first to last: sizes, first and last 64 KiB. What they hold as a stamp needs it, without reading all of them.
std::string dumps_stamp(const GridMatter& grid);

}  // namespace nullscope
