// The judge: rays that the visitor's GPU traced, against the reference tracer.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "compare/error_map.h"
#include "core/exports.h"
#include "reference/frame_tracer.h"
#include "scenefile/scene_file.h"

namespace nullscope::web {
namespace {

struct Judgement {
    CameraSpec camera;
    reference::FrameTracer tracer;
    RayFrame tested;
    std::vector<ErrorTask> tasks;
    std::size_t next = 0;
    ErrorMap errors;
};
std::optional<Judgement> judgement;

std::string spread_json(const Spread& spread) {
    return fmt::format(R"({{"max": {:.6g}, "p999": {:.6g}, "median": {:.6g}, "count": {}}})", spread.max, spread.p999,
                       spread.median, spread.count);
}

}  // namespace

// line: the scene, as scene_as_line() of core.wasm has it. pixels: RayPixel of every pixel, from the top, as trace_rays() of core.wasm gives
// them; none: nothing is compared, for who asks how long it takes. false: the answer says what the reference refuses.
NULLSCOPE_EXPORT(judge)
bool judge(const char* line, std::size_t line_size, int width, int height, const char* pixels, std::size_t bytes) {
    judgement.reset();
    auto scene = scene_of_line({line, line_size});
    if (!scene) return answer(scene.error());
    if (scene->camera.zoom) return answer(bad_input("errors of pixels are not measured in a zoom"));
    scene->camera.width = width, scene->camera.height = height;
    auto tracer = reference::FrameTracer::make(*scene);
    if (!tracer) return answer(tracer.error());
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (bytes != 0 && bytes != count * sizeof(RayPixel))
        return answer(bad_input("the rays are not those of the picture"));
    RayFrame tested{width, height, std::vector<RayPixel>(count)};
    std::memcpy(tested.pixels.data(), pixels, bytes);
    judgement.emplace(Judgement{scene->camera, std::move(*tracer), std::move(tested), error_tasks(width, height), 0,
                                ErrorMap(width, height)});
    return answer(std::string());
}

// Measures some 10 ms of it; whether there is more.
NULLSCOPE_EXPORT(judge_next) bool judge_next() {
    Judgement& j = *judgement;
    if (j.next == j.tasks.size()) return false;
    const ErrorTask task = j.tasks[j.next++];
    const ExactTrace exact = [&](const auto& positions) { return j.tracer.pixels(positions, false); };
    for (const TileErrors& tile : measure_task(j.tested, j.camera, exact, task)) j.errors.take(tile, task.step);
    return j.next < j.tasks.size();
}

// Traces a tile of all its pixels, of those that take most of the time, one here and one there: how many pixels. A ray each, as of pixels that are
// nearly right; those that are off get four more.
NULLSCOPE_EXPORT(judge_trial) int judge_trial(int number) {
    const Judgement& j = *judgement;
    const auto first = std::ranges::find(j.tasks, 0, &ErrorTask::step);
    const auto tiles = static_cast<std::size_t>(j.tasks.end() - first);
    constexpr std::size_t kStride = 7919;  // a prime, more than there are tiles
    const ErrorTask& task = first[static_cast<std::ptrdiff_t>((static_cast<std::size_t>(number) * kStride) % tiles)];
    std::vector<std::array<double, 2>> centres;
    for (int y = task.rect.top; y < task.rect.bottom; ++y)
        for (int x = task.rect.left; x < task.rect.right; ++x) centres.push_back({x + 0.5, y + 0.5});
    return static_cast<int>(j.tracer.pixels(centres, false).size());
}

// What is known by now.
NULLSCOPE_EXPORT(certificate) bool certificate() {
    const ErrorSummary all = judgement->errors.found().summary();
    return answer(fmt::format(
        R"({{"pixels": {}, "measured": {}, "fate_errors": {}, "forgiven": {}, "sky_px": {}, "place_px": {}}})",
        all.pixels, all.measured, all.fate_errors, all.forgiven, spread_json(all.sky_px), spread_json(all.place_px)));
}
// Colours of the errors: RGBA from the top, transparent where nothing is known.
NULLSCOPE_EXPORT(heat) const unsigned char* heat() { return judgement->errors.heat().data.data(); }

}  // namespace nullscope::web
