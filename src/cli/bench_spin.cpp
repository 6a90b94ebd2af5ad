// nullscope bench spin: the shader of a rotating hole against a march in Kerr-Schild coordinates (shaders/mino/kerr_schild.glsl). First the
// screen errors of both against the reference; then, with the march's steps as long as ours allows at the 99.9th percentile, what a frame of
// each costs, drawn in turn; and how many steps our rays take.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/atomic_file.h"
#include "cli/arguments.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/remembered_trace.h"
#include "cli/session.h"
#include "compare/ray_metrics.h"
#include "render/frame_tables.h"
#include "shadercore/core_trace.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string size = "1280x720", context = "auto", json;
    int frames = 9;
};

struct View {
    double spin, r, theta_deg, fov_deg;
};
constexpr View kViews[] = {{0.9, 8, 80, 60}, {0.998, 4, 85, 90}};
constexpr int kErrorWidth = 160;  // columns of the frame that errors are taken on
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
    return scene;
}

Result<RayMeasures> errors_of(Renderer& renderer, const Method& method, const Scene& scene, const ExactTrace& exact) {
    renderer.set_method(method);
    if (Status ready = renderer.prepare(scene); !ready) return ready.error();
    return measure_rays(renderer.ray_data(), scene.camera, exact);
}

struct Steps {
    double mean = 0;
    int most = 0;
    long long at_cap = 0, rays = 0;
};
// Of every second pixel of every second row, by the same text in float on the CPU.
Result<Steps> steps_of(const Scene& scene) {
    FrameTables tables;
    if (Status ready = tables.update(scene); !ready) return ready.error();
    const CoreInput input = tables.core_input();
    Steps steps;
    double sum = 0;
    for (int y = 0; y < scene.camera.height; y += 2)
        for (int x = 0; x < scene.camera.width; x += 2) {
            const int n =
                trace_core32(input, x + 0.5 - 0.5 * scene.camera.width, 0.5 * scene.camera.height - y - 0.5).steps;
            sum += n, steps.most = std::max(steps.most, n), steps.at_cap += n >= kCap, ++steps.rays;
        }
    steps.mean = sum / static_cast<double>(steps.rays);
    return steps;
}

Result<JsonObject> measure(Session& session, Renderer& march, const gl::Target& target, const View& view, int frames) {
    const Scene scene = scene_of(view, target.width, target.height),
                small = scene_of(view, kErrorWidth, kErrorWidth * target.height / target.width);
    const double finer = static_cast<double>(target.width) / kErrorWidth;
    const ExactTrace exact = remembered_trace(small);
    const auto ours = errors_of(*session.renderer, Method{}, small, exact);
    if (!ours) return ours.error();
    fmt::print(
        "{}: ours {:.4f} px at most, {:.4f} at the 99.9th percentile, {:.5f} in the median of {}x{}; fate errors {}\n",
        scene.name, ours->sky_px.max * finer, ours->sky_px.p999 * finer, ours->sky_px.median * finer, target.width,
        target.height, ours->fate_errors);
    Method chosen{.kind = MethodKind::kKerrSchild};
    Spread reached;
    bool met = false;
    for (double step = kLongest; step > kShortest && !met; step *= kShorter) {
        const Method method{.kind = MethodKind::kKerrSchild, .step = step};
        const auto theirs = errors_of(march, method, small, exact);
        if (!theirs) return theirs.error();
        fmt::print(
            "  Kerr-Schild RK4, step {:.4f} r: {:.4f} px at most, {:.4f} at the 99.9th percentile, {:.5f} in the "
            "median; fate errors {}\n",
            step, theirs->sky_px.max * finer, theirs->sky_px.p999 * finer, theirs->sky_px.median * finer,
            theirs->fate_errors);
        met = theirs->sky_px.p999 <= ours->sky_px.p999;
        if (met || reached.count == 0 || theirs->sky_px.p999 < reached.p999) chosen = method, reached = theirs->sky_px;
    }
    session.renderer->set_method(Method{});
    march.set_method(chosen);
    if (Status ready = session.renderer->prepare(scene); !ready) return ready.error();
    if (Status ready = march.prepare(scene); !ready) return ready.error();
    const auto draw = [&](Renderer& renderer) {
        renderer.draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay);
    };
    for (Renderer* renderer : {session.renderer.get(), &march}) draw(*renderer);  // compiles
    Samples own, other;
    for (int i = 0; i < frames; ++i) {
        time_one(own, [&] { draw(*session.renderer); });
        time_one(other, [&] { draw(march); });
    }
    const auto steps = steps_of(scene);
    if (!steps) return steps.error();
    const double core = median(own.core_s), core_march = median(other.core_s);
    fmt::print("  {}step {:.4f} r; a frame: ours {:.4f} core-s, the march {:.4f} core-s: {:.1f} times as dear\n",
               met ? "as exact with " : "never as exact, nearest with ", chosen.step, core, core_march,
               core_march / core);
    fmt::print("  our rays take {:.2f} steps, {} at most; {} of {} at the cap of {}\n", steps->mean, steps->most,
               steps->at_cap, steps->rays, kCap);
    JsonObject row;
    row.add("scene", scene.name).add("width", target.width).add("height", target.height).add("frames", frames);
    row.add("max_px", ours->sky_px.max * finer)
        .add("p999_px", ours->sky_px.p999 * finer)
        .add("march_step", chosen.step);
    row.add("march_max_px", reached.max * finer)
        .add("march_p999_px", reached.p999 * finer)
        .add("as_exact", met ? "yes" : "no");
    row.add("core_seconds", core).add("march_core_seconds", core_march).add("ratio", core_march / core);
    row.add("mean_steps", steps->mean).add("most_steps", steps->most).add("at_cap", steps->at_cap);
    return row;
}

int run(const Options& options) {
    const auto size = parse_size(options.size);
    if (!size) return report(size.error());
    auto session = open_session(options.context);
    if (!session) return report(session.error());
    Renderer march;
    const gl::Target target = gl::make_target(size->width, size->height, gl::Format::kRgba8);
    std::vector<JsonObject> rows;
    for (const View& view : kViews) {
        auto row = measure(*session, march, target, view, options.frames);
        if (!row) return report(row.error());
        rows.push_back(std::move(*row));
    }
    if (options.json.empty()) return 0;
    if (Status written = write_text_atomically(options.json, json_list(rows)); !written) return report(written.error());
    return 0;
}

}  // namespace

void add_bench_spin(Command& bench) {
    auto options = std::make_shared<Options>();
    Command& command = bench.add_command(
        "spin", "A rotating hole's rays against a march in Kerr-Schild coordinates: errors, then cost");
    command.add_option("--size", &options->size, "Frame size, WIDTHxHEIGHT").show_default();
    context_option(command, options->context);
    command.add_option("--frames", &options->frames, "Frames of each kind").in_range(3, 10000).show_default();
    command.add_option("--json", &options->json, "Write the rows to this file");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
