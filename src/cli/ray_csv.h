// Lists of rays as CSV: what `nullscope trace` reads and prints (docs/ray-data.md has every column).
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "command/ray_trace.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::cli {

inline constexpr std::size_t kLargestRayFile = std::size_t{1} << 30;  // bytes

struct RayRow {
    int line = 0;      // in the file, from 1
    std::string text;  // as it stands there: the output repeats it
};

struct RayTable {
    std::string file;
    std::string header;
    std::vector<RayRow> rows;
    std::vector<RayQuery> queries;  // of the rows
};

using RayRecords = std::vector<std::optional<RayRecord>>;  // of the rows; nothing: it could not be traced

// One header line names the columns, in any order; others than those known are passed through. Lines that start with #
// and empty lines are skipped. Fields may stand in double quotes; lines end with LF or CR LF.
// Errors: one line "FILE:LINE: COLUMN: what is wrong; allowed: ..." for the first fault.
Result<RayTable> read_rays(const std::string& path, const Spacetime& spacetime);
Result<RayTable> parse_rays(std::string_view text, const std::string& file, const Spacetime& spacetime);

// Of a row's ray: "FILE:LINE: what".
Error ray_error(const RayTable& table, std::size_t row, const Error& error);

// Columns behind all others: a name, or a row's fields, each with a comma before it.
struct MoreColumns {
    std::string header;
    std::vector<std::string> rows;  // as many as rays, or none
};

// The rays' own columns, then what was found: fate, ..., at, then `columns` of each crossing: r_1, phi_1, ... A row without a record gets
// empty fields.
// scene: gives the names of bodies. Lengths are divided by length_unit (Spacetime::length_unit), by which reading has multiplied them.
std::string rays_text(const RayTable& table, const Scene& scene, const RayRecords& records, int crossings,
                      std::span<const CrossingColumn> columns, double length_unit = 1.0, const MoreColumns& more = {});

}  // namespace nullscope::cli
