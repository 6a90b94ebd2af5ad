#include "scene/medium_dumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include "base/file_part.h"
#include "base/numbered_files.h"
#include "base/text.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "medium.file";
constexpr std::size_t kWitness = 1u << 16;  // bytes of either end of a dump

std::optional<NumberedFiles> files_of(const GridMatter& grid) {
    return NumberedFiles::parse(grid.file.filename().string(), grid.file.parent_path().string());
}

std::string name_of(const fs::path& file) { return in_quotes(without_controls(file.filename().string())); }

// Of the first dump's time, in dumps; on a dump within a rounding.
double dump_at(const GridMatter& grid, double time) {
    constexpr double kSame = 1e-9;
    const double at = (time - grid.start) / grid.cadence, nearest = std::round(at);
    return std::abs(at - nearest) <= kSame * std::max(1.0, std::abs(at)) ? nearest : at;
}

Result<MediumGrid> head_of(const fs::path& file) {
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);
    return MediumGrid::parse_head(file_part(file, MediumGrid::kMostHead, FileEnd::kFirst), file.string(),
                                  none ? 0 : static_cast<std::size_t>(size));
}

SceneFault other_nodes(const fs::path& file, const fs::path& first, const char* what) {
    return {kFile, fmt::format("{} has other {} than {}", name_of(file), what, name_of(first)),
            "the same coordinates, spin and nodes in all dumps"};
}

struct Stamp {
    fs::file_time_type time{};
    std::uintmax_t size = 0;
    explicit Stamp(const fs::path& file) {
        std::error_code none;
        time = fs::last_write_time(file, none), size = fs::file_size(file, none);
    }
    friend bool operator==(const Stamp&, const Stamp&) = default;
};

// A series without a fault, and when its folder and its files were changed last.
struct Judged {
    GridMatter grid;
    fs::file_time_type folder{};
    std::vector<Stamp> files;
    MediumGrid form;  // of the first
};

// known: heads of its files that are as they were are not read again.
std::optional<SceneFault> judge(const GridMatter& grid, const NumberedFiles& files, const Judged& known,
                                Judged& judged) {
    const fs::path first = files.of(grid.first);
    const std::vector<int> there = files.on_disk();
    auto at = std::ranges::lower_bound(there, grid.first);
    for (int number = grid.first; number <= grid.last; ++number, ++at)
        if (at == there.end() || *at != number)
            return SceneFault{
                kFile, fmt::format("there is no file {}", name_of(files.of(number))),
                fmt::format("all of {} to {}, or other first and last", name_of(first), name_of(files.of(grid.last)))};
    const bool same = known.grid == grid;
    for (int number = grid.first; number <= grid.last; ++number) {
        const fs::path file = files.of(number);
        const std::size_t n = judged.files.size();
        judged.files.emplace_back(file);
        if (same && known.files.front() == judged.files.front() && known.files[n] == judged.files[n]) {
            if (n == 0) judged.form = known.form;
            continue;
        }
        if (std::error_code error; !fs::is_regular_file(file, error))  // a pipe would be waited for
            return SceneFault{kFile, fmt::format("{} is not a regular file", name_of(file)), "grids of matter"};
        auto head = head_of(file);
        if (!head) return file_fault(kFile, file, head.error(), "a grid of matter");
        if (n == 0)
            judged.form = std::move(*head);
        else if (const char* what = head->other_nodes(judged.form))
            return other_nodes(file, first, what);
    }
    judged.grid = grid;
    return std::nullopt;
}

using Grid = std::shared_ptr<const MediumGrid>;
std::atomic<long long> read_count = 0;

Result<Grid> read_dump(const fs::path& file) {
    ++read_count;
    TRY(grid, MediumGrid::read(file));
    return std::make_shared<const MediumGrid>(std::move(*grid));
}

// What is kept of the dumps of one scene.
class Held {
public:
    fs::path pattern;
    long long used = 0;

    Result<Grid> at(const std::vector<fs::path>& files, double part) {
        std::vector<Dump> asked;
        asked.reserve(files.size());
        for (const fs::path& file : files) asked.push_back({file, Stamp(file), Grid()});
        std::erase_if(dumps_, [&](const Dump& dump) {  // before others are read
            return std::ranges::none_of(asked,
                                        [&](const Dump& a) { return a.file == dump.file && a.stamp == dump.stamp; });
        });
        for (Dump& dump : asked) {
            const auto held = std::ranges::find(dumps_, dump.file, &Dump::file);
            dump.grid = held != dumps_.end() ? held->grid : Result<Grid>(Grid());
            if (held == dumps_.end()) between_.reset(), dump.grid = read_dump(dump.file), dumps_.push_back(dump);
            if (!dump.grid) return dump.grid.error();
        }
        const Grid& a = *asked.front().grid;
        if (asked.size() == 1) {
            between_.reset();
            return a;
        }
        const Grid& b = *asked.back().grid;
        if (const char* what = b->other_nodes(*a)) {
            const SceneFault fault = other_nodes(asked.back().file, asked.front().file, what);
            return bad_input(fault.what, fault.allowed);
        }
        if (between_ == nullptr || part_ != part) {
            between_.reset();
            between_ = std::make_shared<const MediumGrid>(MediumGrid::between(*a, *b, part));
            part_ = part;
        }
        return between_;
    }

private:
    struct Dump {
        fs::path file;
        Stamp stamp;
        Result<Grid> grid;
    };
    std::vector<Dump> dumps_;  // two at most
    Grid between_;             // of both, at part_
    double part_ = 0;
};

}  // namespace

bool has_dumps(const GridMatter& grid) { return names_numbers(grid.file.filename().string()); }

bool has_dumps(const Scene& scene) {
    return scene.medium && scene.medium->kind == MediumKind::kGrid && has_dumps(scene.medium->grid);
}

bool has_slow_light(const Scene& scene) { return has_dumps(scene) && scene.medium->grid.light == DumpLight::kSlow; }

void settle_dumps(GridMatter& grid) {
    const auto files = has_dumps(grid) ? files_of(grid) : std::nullopt;
    if (!files || (grid.first >= 0 && grid.last >= 0)) return;
    const std::vector<int> there = files->on_disk();
    if (there.empty()) return;
    if (grid.first < 0) grid.first = there.front();
    if (grid.last < 0) grid.last = there.back();
}

DumpTimes dump_times(const GridMatter& grid) {
    return {grid.start, grid.start + (grid.last - grid.first) * grid.cadence};
}

std::string dump_words(const GridMatter& grid) {
    const auto [from, to] = dump_times(grid);
    const int count = grid.last - grid.first + 1;
    return fmt::format("{} dump{}, {} to {}, at times [{:.9g}, {:.9g}] r_s/c", count, count == 1 ? "" : "s", grid.first,
                       grid.last, from, to);
}

std::optional<SceneFault> dump_fault(const GridMatter& grid) {
    static std::mutex mutex;
    static Judged known;
    const auto files = files_of(grid);
    if (!files)
        return SceneFault{
            kFile, fmt::format("{} has more than one placeholder for a number, or one too long", name_of(grid.file)),
            fmt::format("one of {} (up to {} digits), in the file's name", kNumberPlaces, kMostNumberDigits)};
    if (grid.first < 0 || grid.last < 0)
        return SceneFault{kFile, fmt::format("there is no file {}", name_of(grid.file)),
                          "files that a number tells apart"};
    if (grid.last < grid.first)
        return SceneFault{"medium.last", fmt::format("{} is below first = {}", grid.last, grid.first), "first <= last",
                          kFile};
    std::error_code none;
    const auto folder = grid.file.parent_path();
    const auto time = fs::last_write_time(folder.empty() ? fs::path(".") : folder, none);
    const std::lock_guard lock(mutex);
    if (known.grid == grid && known.folder == time) return std::nullopt;
    Judged judged;
    judged.folder = time;
    auto fault = judge(grid, *files, known, judged);
    if (!fault) known = std::move(judged);
    return fault;
}

std::optional<SceneFault> dump_time_fault(const GridMatter& grid, double time) {
    if (const double at = dump_at(grid, time); at >= 0 && at <= grid.last - grid.first) return std::nullopt;
    const auto [from, to] = dump_times(grid);
    return SceneFault{"time", fmt::format("{:.9g} is not between the dumps of {}", time, kFile),
                      fmt::format("[{:.9g}, {:.9g}] r_s/c, of dumps {} to {}", from, to, grid.first, grid.last), kFile};
}

std::vector<fs::path> dumps_about(const GridMatter& grid, double time) {
    const auto files = files_of(grid);
    if (!files) return {};
    const double at = std::clamp(dump_at(grid, time), 0.0, static_cast<double>(std::max(grid.last - grid.first, 0))),
                 low = std::floor(at);
    const int first = grid.first + static_cast<int>(low);
    std::vector<fs::path> about = {files->of(first)};
    if (at > low) about.emplace_back(files->of(first + 1));
    return about;
}

Result<std::shared_ptr<const MediumGrid>> medium_grid_at(const GridMatter& grid, double time) {
    if (!has_dumps(grid)) return load_medium_grid(grid.file);
    if (!(grid.cadence > 0) || grid.first < 0 || grid.last < grid.first)
        return bad_input("medium.file: dumps without their numbers or the time between them");
    if (const auto fault = dump_time_fault(grid, time)) return bad_key(fault->key, fault->what, fault->allowed);
    static std::mutex mutex;
    static std::array<Held, 2> kept;
    static long long asked = 0;
    const std::lock_guard lock(mutex);
    auto held = std::ranges::find(kept, grid.file, &Held::pattern);
    if (held == kept.end()) {
        held = std::ranges::min_element(kept, {}, &Held::used);
        *held = Held();
        held->pattern = grid.file;
    }
    held->used = ++asked;
    const double at = dump_at(grid, time);
    return held->at(dumps_about(grid, time), at - std::floor(at));
}

Result<std::shared_ptr<const MediumGrid>> medium_grid_at(const Scene& scene) {
    return medium_grid_at(scene.medium->grid, scene.time);
}

Result<MediumGrid> medium_form(const Scene& scene) {
    const GridMatter& matter = scene.medium->grid;
    if (has_slow_light(scene)) {
        const auto files = files_of(matter);
        if (!files || matter.first < 0) return bad_input("medium.file: dumps without their numbers");
        return head_of(files->of(matter.first));
    }
    TRY(grid, medium_grid_at(scene));
    return (*grid)->without_numbers();
}

Result<MediumGrid> read_medium_dump(const GridMatter& grid, int dump, const MediumGrid& form) {
    const auto files = files_of(grid);
    if (!files || dump < 0 || dump > grid.last - grid.first) return bad_input("medium.file: there is no such dump");
    const fs::path file = files->of(grid.first + dump);
    ++read_count;
    TRY(read, MediumGrid::read(file));
    if (const char* what = read->other_nodes(form)) {
        const SceneFault fault = other_nodes(file, files->of(grid.first), what);
        return bad_input(fault.what, fault.allowed);
    }
    return std::move(*read);
}

DumpStamp dump_stamp(const GridMatter& grid, int dump) {
    const auto files = files_of(grid);
    const Stamp stamp(files ? fs::path(files->of(grid.first + dump)) : fs::path());
    return {dump, stamp.time, stamp.size};
}

Result<std::shared_ptr<const MediumGrids>> medium_grids(const GridMatter& grid, int from, int to) {
    struct Dump {
        fs::path file;
        Stamp stamp;
        Grid grid;
    };
    static std::mutex mutex;
    static std::vector<Dump> kept;
    const auto files = files_of(grid);
    if (!files || from > to) return bad_input("medium.file: there are no such dumps");
    const std::lock_guard lock(mutex);
    std::vector<Dump> asked;
    for (int dump = from; dump <= to; ++dump) {
        const fs::path file = files->of(grid.first + dump);
        asked.push_back({file, Stamp(file), nullptr});
        for (const Dump& held : kept)
            if (held.file == asked.back().file && held.stamp == asked.back().stamp) asked.back().grid = held.grid;
    }
    kept.clear();  // before others are read
    TRY(form, head_of(files->of(grid.first)));
    auto found = std::make_shared<MediumGrids>();
    for (int dump = from; dump <= to; ++dump) {
        Dump& one = asked[static_cast<std::size_t>(dump - from)];
        if (one.grid == nullptr) {
            TRY(read, read_medium_dump(grid, dump, *form));
            one.grid = std::make_shared<const MediumGrid>(std::move(*read));
        }
        found->push_back(one.grid);
    }
    kept = std::move(asked);
    return std::shared_ptr<const MediumGrids>(std::move(found));
}

long long dumps_read() { return read_count; }

std::string dumps_stamp(const GridMatter& grid) {
    const auto files = files_of(grid);
    if (!files) return "unreadable";
    std::uint64_t hash = fnv1a("");
    for (int number = grid.first; number <= grid.last; ++number) {
        const fs::path file = files->of(number);
        std::error_code none;
        hash = fnv1a(fmt::format("{} {}", number, fs::file_size(file, none)), hash);
        hash = fnv1a(file_part(file, kWitness, FileEnd::kFirst), hash);
        hash = fnv1a(file_part(file, kWitness, FileEnd::kLast), hash);
    }
    return fmt::format("{} files, {:016x}", grid.last - grid.first + 1, hash);
}

}  // namespace nullscope
