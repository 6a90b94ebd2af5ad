#include "render/stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "platform/places.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = 1u << 20;  // bytes: kMostRows of a thousand
constexpr double kLongestFrame_ms = 1e7;
constexpr const char* kColumns = "device,kind,fragment_ms,compute_ms\n";

std::optional<StageMemory::Row> row_of(std::string_view line) {
    const auto fields = csv_fields(line);
    if (!fields || fields->size() != 4) return std::nullopt;
    const auto fragment = parse_number((*fields)[2]), compute = parse_number((*fields)[3]);
    const auto is_time = [](const auto& ms) { return ms && *ms > 0.0 && *ms < kLongestFrame_ms; };
    if (!is_time(fragment) || !is_time(compute)) return std::nullopt;
    return StageMemory::Row{(*fields)[0], (*fields)[1], {*fragment, *compute}};
}

}  // namespace

std::string StageTimes::words() const {
    return fmt::format("{:.5g} ms a frame by fragments, {:.5g} by compute", fragment_ms, compute_ms);
}

fs::path stage_file() {
    const fs::path folder = platform::state_folder();
    return folder.empty() ? folder : folder / "stages.csv";
}

std::string scene_kind(const std::string& metric, const EffectSet& effects, const Method& method, Tiles tiles) {
    constexpr const char* kTiles[] = {"no tiles", "tiles", "traced tiles", "interpolated tiles"};
    std::string kind = fmt::format("{} {}, {}:", metric, method_name(method), kTiles[static_cast<int>(tiles)]);
    for (const Effect effect : with_one_ray(effects).list()) kind += fmt::format(" {}", effect_row(effect).key);
    return kind;
}

StageMemory::StageMemory(fs::path file) : file_(std::move(file)) { read(); }

void StageMemory::read() {
    std::error_code error;
    if (file_.empty() || !fs::is_regular_file(file_, error)) return;
    const Result<std::string> text = read_text(file_, kLargestFile);
    if (!text) return;
    rows_.clear();
    for (CsvLines lines(*text); lines.next();)
        if (auto row = row_of(lines.line)) rows_.push_back(std::move(*row));
}

std::optional<StageTimes> StageMemory::find(const std::string& device, const std::string& kind) const {
    const auto found =
        std::ranges::find_if(rows_, [&](const Row& row) { return row.device == device && row.kind == kind; });
    return found == rows_.end() ? std::nullopt : std::optional(found->times);
}

std::vector<StageMemory::Row> StageMemory::of_kind(const std::string& kind) const {
    std::vector<Row> found;
    std::ranges::copy_if(rows_, std::back_inserter(found), [&](const Row& row) { return row.kind == kind; });
    return found;
}

Status StageMemory::keep(const std::string& device, const std::string& kind, const StageTimes& times) {
    read();
    std::erase_if(rows_, [&](const Row& row) { return row.device == device && row.kind == kind; });
    rows_.push_back({device, kind, times});
    if (rows_.size() > kMostRows) rows_.erase(rows_.begin(), rows_.end() - kMostRows);
    if (file_.empty()) return Done{};
    std::string text = kColumns;
    for (const Row& row : rows_)
        text += fmt::format("{},{},{:.9g},{:.9g}\n", csv_field(without_controls(row.device)),
                            csv_field(without_controls(row.kind)), row.times.fragment_ms, row.times.compute_ms);
    std::error_code error;
    fs::create_directories(file_.parent_path(), error);  // if it fails, writing says so
    return write_text_atomically(file_, text);
}

}  // namespace nullscope
