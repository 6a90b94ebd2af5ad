// nullscope bench spin: the shader of a rotating hole against a march in Kerr-Schild coordinates (shaders/mino/kerr_schild.glsl). First the
// screen errors of both against the reference; then, with the march's steps as long as ours allows at the 99.9th percentile, what a frame of
// each costs, drawn in turn; and how many steps our rays take, alone and in blocks that a GPU traces in step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/bench.h"
#include "command/exact_trace.h"
#include "command/json.h"
#include "compare/ray_metrics.h"
#include "compare/remembered_trace.h"
#include "render/frame_tables.h"
#include "shadercore/core_trace.h"

namespace nullscope::cli {
namespace {

struct View {
    double spin, r, theta_deg, fov_deg;
};
constexpr View kViews[] = {{0.9, 8, 80, 60}, {0.998, 4, 85, 90}};
constexpr int kErrorWidthBySpin = 160;  // columns of the frame that errors are taken on
constexpr double kLongest = 0.64, kShortest = 0.004,
                 kShorter = 0.7071067811865476;  // steps of the march that are tried
constexpr int kCap = 64;                         // SPIN_MOST_STEPS

Scene scene_of(const View& view, int width, int height) {
    Scene scene;
    scene.name = fmt::format("a = {}, r = {}", view.spin, view.r);
    scene.spacetime = {"kerr", {{"spin", view.spin}}};
    scene.camera.observer = ObserverKind::kZamo;
    scene.camera.r = view.r, scene.camera.theta = view.theta_deg * M_PI / 180;
    scene.camera.plane_width = 2 * std::tan(0.5 * view.fov_deg * M_PI / 180);
    scene.camera.width = width, scene.camera.height = height;
    scene.sky.kind = SkyKind::kGrid;
    scene.picture.refine = false;  // one ray a pixel, by both
    return scene;
}

Result<RayMeasures> errors_of(Renderer& renderer, const Method& method, const Scene& scene, const ExactTrace& exact) {
    renderer.set_method(method);
    TRY(ready, renderer.prepare(scene));
    return measure_rays(renderer.ray_data(), scene.camera, exact);
}

std::string words_of(const Spread& px, double finer) {
    return fmt::format("{:.4f} px at most, {:.4f} at the 99.9th percentile, {:.5f} in the median", px.max * finer,
                       px.p999 * finer, px.median * finer);
}

constexpr int kBlockWidth = 8, kBlockHeight = 4;  // px: threads that a GPU runs in step

struct Steps {
    double mean = 0;
    double at_work = 0;  // part of the threads of a block, on the mean, until its longest ray ends
    int most = 0;
    long long at_cap = 0, rays = 0;
};
// Of every second block of every second row of them, by the same text in float on the CPU.
Result<Steps> steps_of(const Scene& scene) {
    FrameTables tables;
    TRY(ready, tables.update(scene));
    const CoreInput input = tables.core_input();
    const CameraSpec& camera = scene.camera;
    Steps steps;
    double sum = 0, taken = 0;  // taken: if each ray took as long as its block's longest
    for (int top = 0; top + kBlockHeight <= camera.height; top += 2 * kBlockHeight)
        for (int left = 0; left + kBlockWidth <= camera.width; left += 2 * kBlockWidth) {
            int longest = 0;
            for (int i = 0; i < kBlockWidth * kBlockHeight; ++i) {
                const int column = left + i % kBlockWidth, row = top + i / kBlockWidth;
                const double x = column + 0.5, y = row + 0.5;
                const int n = trace_core32(input, x - 0.5 * camera.width, 0.5 * camera.height - y).steps;
                sum += n, longest = std::max(longest, n), steps.at_cap += n >= kCap, ++steps.rays;
            }
            taken += longest * kBlockWidth * kBlockHeight, steps.most = std::max(steps.most, longest);
        }
    steps.mean = sum / static_cast<double>(steps.rays), steps.at_work = sum / taken;
    return steps;
}

Result<Json> measure_spin(const Bench& bench, const View& view, int frames) {
    const int width = bench.target.width, height = bench.target.height;
    const Scene scene = scene_of(view, width, height),
                small = scene_of(view, kErrorWidthBySpin, kErrorWidthBySpin * height / width);
    const double finer = static_cast<double>(width) / kErrorWidthBySpin;
    const ExactTrace exact = remembered(exact_trace(small));
    TRY(ours, errors_of(bench.renderer(), Method{}, small, exact));
    fmt::print("{}: ours {} of {}x{}; fate errors {}\n", scene.name, words_of(ours->sky_px, finer), width, height,
               ours->fate_errors);
    Method chosen{.kind = MethodKind::kKerrSchild};
    Spread reached;
    bool met = false;
    for (double step = kLongest; step > kShortest && !met; step *= kShorter) {
        const Method method{.kind = MethodKind::kKerrSchild, .step = step};
        TRY(theirs, errors_of(*bench.other, method, small, exact));
        fmt::print("  Kerr-Schild RK4, step {:.4f} r: {}; fate errors {}\n", step, words_of(theirs->sky_px, finer),
                   theirs->fate_errors);
        met = theirs->sky_px.p999 <= ours->sky_px.p999;
        if (met || reached.count == 0 || theirs->sky_px.p999 < reached.p999) chosen = method, reached = theirs->sky_px;
    }
    bench.renderer().set_method(Method{});
    bench.other->set_method(chosen);
    TRY(ready, bench.prepare(scene, scene));
    const auto samples = bench.time_in_turn(frames);
    TRY(steps, steps_of(scene));
    const double core = median(samples[0].core_s), core_march = median(samples[1].core_s);
    fmt::print("  {}step {:.4f} r; a frame: ours {:.4f} core-s, the march {:.4f} core-s: {:.1f} times the cost\n",
               met ? "as accurate with " : "never as accurate, nearest with ", chosen.step, core, core_march,
               core_march / core);
    fmt::print("  our rays take {:.2f} steps, {} at most; {} of {} at the cap of {}\n", steps->mean, steps->most,
               steps->at_cap, steps->rays, kCap);
    fmt::print("  of blocks of {} x {} pixels that are traced in step {:.1f} % of the threads are at work\n",
               kBlockWidth, kBlockHeight, 100 * steps->at_work);
    return Json{{"scene", scene.name},
                {"width", width},
                {"height", height},
                {"frames", frames},
                {"max_px", ours->sky_px.max * finer},
                {"p999_px", ours->sky_px.p999 * finer},
                {"march_step", chosen.step},
                {"march_max_px", reached.max * finer},
                {"march_p999_px", reached.p999 * finer},
                {"as_exact", met ? "yes" : "no"},
                {"core_seconds", core},
                {"march_core_seconds", core_march},
                {"ratio", core_march / core},
                {"mean_steps", steps->mean},
                {"most_steps", steps->most},
                {"at_cap", steps->at_cap},
                {"threads_at_work", steps->at_work}};
}

Status run_spin(const BenchOptions& options) {
    TRY(bench, open_bench(options));
    Json rows = Json::array();
    for (const View& view : kViews) {
        TRY(row, measure_spin(*bench, view, options.frames));
        rows.push_back(std::move(*row));
    }
    return write_json(options.json, rows);
}

}  // namespace

void add_bench_spin(Command& bench) {
    auto [command, options] = add_command<BenchOptions>(
        bench, "spin", "Rotating hole: errors and cost of our rays against a ray march in Kerr-Schild coordinates",
        run_spin);
    options.frames = 9;
    draw_options(command, options, 3);
    json_option(command, options);
}

}  // namespace nullscope::cli
