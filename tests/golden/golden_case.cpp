#include "golden/golden_case.h"

#include <fmt/format.h>

#include <array>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "scenefile/scene_file.h"
#include "support/folders.h"

namespace nullscope::test {
namespace {

constexpr std::size_t kColumns = 8;

Result<GoldenCase> parse_case(std::string_view line) {
    const auto cells = csv_fields(line).value_or(std::vector<std::string>());
    if (cells.size() < kColumns) return bad_input(fmt::format("{} columns instead of {}", cells.size(), kColumns));
    GoldenCase golden;
    golden.scene = cells[0];
    golden.name = std::filesystem::path(cells[0]).stem().string();
    const auto sides = split(cells[1], 'x');
    std::array<std::optional<double>, 6> numbers;
    if (sides.size() == 2) numbers[0] = parse_number(sides[0]), numbers[1] = parse_number(sides[1]);
    for (std::size_t i = 2; i < numbers.size(); ++i) numbers[i] = parse_number(cells[i + 1]);
    for (const auto& number : numbers)
        if (!number || !(*number >= 0)) return bad_input("a size or a tolerance is no number");
    golden.width = static_cast<int>(*numbers[0]);
    golden.height = static_cast<int>(*numbers[1]);
    golden.contexts = cells[2];
    golden.rays_px = *numbers[2];
    golden.mean = *numbers[3];
    golden.above = *numbers[4];
    golden.fraction = *numbers[5];
    for (std::size_t i = kColumns - 1; i < cells.size(); ++i)
        golden.reason += (golden.reason.empty() ? "" : ", ") + cells[i];
    if (golden.reason.empty()) return bad_input("no reason for the tolerances");
    return golden;
}

}  // namespace

std::filesystem::path golden_folder() { return data_folder() / "golden"; }

Result<std::vector<GoldenCase>> read_golden_cases(const std::filesystem::path& file) {
    const auto text = read_text(file);
    if (!text) return text.error();
    std::vector<GoldenCase> cases;
    bool heading = true;
    for (CsvLines csv(*text); csv.next();) {
        if (std::exchange(heading, false)) continue;
        auto golden = parse_case(csv.line);
        if (!golden)
            return bad_input(fmt::format("{}:{}: {}", file.filename().string(), csv.number, golden.error().message()));
        cases.push_back(std::move(*golden));
    }
    return cases;
}

Result<Scene> golden_scene(const GoldenCase& golden) {
    auto scene = load_scene(golden.scene.ends_with(".toml") ? (golden_folder() / golden.scene).string() : golden.scene);
    if (!scene) return scene.error();
    scene->camera.width = golden.width;
    scene->camera.height = golden.height;
    return scene;
}

}  // namespace nullscope::test
