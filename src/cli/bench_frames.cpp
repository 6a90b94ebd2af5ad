// nullscope bench frames: what a frame costs, against the same frame in flat space and against one bare cube-map fetch a pixel,
// drawn in turn (A B C A B C ...) so that a noisy machine does not decide.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/arguments.h"
#include "cli/bench.h"
#include "cli/bench_effects.h"
#include "cli/json.h"
#include "cli/session.h"
#include "scene/scene_file.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::vector<std::string> scenes = {"flat", "sky-only", "first-light"};
    std::string size = "1280x720", context = "auto", json;
    int frames = 21, poses = 0;
    bool effects = false;
};

// One renderer for the scene and one for its floor, on one context.
struct Bench {
    Session session;
    std::unique_ptr<Renderer> floor;
    gl::Target target;
};

Scene flat_twin(Scene scene) {
    scene.spacetime = {"minkowski", {}};
    return scene;
}

Status prepare(Bench& bench, const Scene& scene) {
    if (Status ready = bench.session.renderer->prepare(scene); !ready) return ready;
    return bench.floor->prepare(flat_twin(scene));
}

Result<JsonObject> measure(Bench& bench, const Scene& scene, int frames) {
    if (Status ready = prepare(bench, scene); !ready) return ready.error();
    Samples picture, floor, fetch;
    const int w = scene.camera.width, h = scene.camera.height;
    const unsigned to = bench.target.framebuffer.id();
    Renderer& renderer = *bench.session.renderer;
    const auto first = std::chrono::steady_clock::now();
    renderer.draw(to, w, h, Output::kDisplay);  // compiles
    gl::finish();
    const double first_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - first).count();
    bench.floor->draw(to, w, h, Output::kDisplay);
    bench.floor->draw_bare_fetch(to, w, h);  // whose sky is a cube map, a wormhole's or not
    Progress progress("bench " + scene.name, frames);
    for (int i = 0; i < frames; ++i) {
        time_one(picture, [&] { renderer.draw(to, w, h, Output::kDisplay); });
        time_one(floor, [&] { bench.floor->draw(to, w, h, Output::kDisplay); });
        time_one(fetch, [&] { bench.floor->draw_bare_fetch(to, w, h); });
        progress.advance();
    }
    const auto [low, high] = std::minmax_element(picture.wall_ms.begin(), picture.wall_ms.end());
    const double core = median(picture.core_s);
    JsonObject row;
    row.add("scene", scene.name)
        .add("context", bench.session.context->kind())
        .add("renderer", renderer.info().renderer);
    row.add("width", w).add("height", h).add("frames", frames);
    row.add("median_ms", median(picture.wall_ms)).add("min_ms", *low).add("max_ms", *high);
    row.add("core_seconds", core).add("compile_ms", first_ms);
    row.add("table_ms", renderer.tables().path().table_ms + renderer.tables().path().rows_ms);
    row.add("floor_ratio", core / median(floor.core_s)).add("fetch_ratio", core / median(fetch.core_s));
    row.add("floor_core_seconds", median(floor.core_s));
    fmt::print(
        "{:<18} {:7.2f} ms ({:.2f} to {:.2f})  {:.4f} core-s  {:5.2f} x floor  {:5.2f} x fetch  first frame {:.0f} ms, "
        "tables {:.1f} ms\n",
        scene.name, median(picture.wall_ms), *low, *high, core, core / median(floor.core_s),
        core / median(fetch.core_s), first_ms, renderer.tables().path().table_ms + renderer.tables().path().rows_ms);
    return row;
}

// Random places and directions, some close, some far, most of them with the hole in view.
Scene random_pose(Scene scene, std::mt19937& random) {
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    scene.camera.r = 1.02 * std::pow(100.0, uniform(0.0, 1.0));
    scene.camera.theta = std::acos(uniform(-1.0, 1.0));
    scene.camera.phi = uniform(0.0, 2 * M_PI);
    scene.camera.yaw = uniform(-0.6, 0.6);
    scene.camera.pitch = uniform(-0.4, 0.4);
    scene.camera.roll = uniform(-M_PI, M_PI);
    return scene;
}

// Cost over random poses: dearest over cheapest, by the least of three frames each.
Result<double> pose_ratio(Bench& bench, const Scene& scene, int poses) {
    std::mt19937 random(20151127);
    double cheapest = 1e30, dearest = 0.0;
    Progress progress("poses of " + scene.name, poses);
    for (int i = 0; i < poses; ++i, progress.advance()) {
        const Scene posed = random_pose(scene, random);
        if (Status ready = bench.session.renderer->prepare(posed); !ready) return ready.error();
        Samples samples;
        for (int k = 0; k < 3; ++k)
            time_one(samples, [&] {
                bench.session.renderer->draw(bench.target.framebuffer.id(), posed.camera.width, posed.camera.height,
                                             Output::kDisplay);
            });
        const double cost = *std::min_element(samples.core_s.begin(), samples.core_s.end());
        cheapest = std::min(cheapest, cost);
        dearest = std::max(dearest, cost);
    }
    fmt::print("{:<18} {} random poses: {:.4f} to {:.4f} core-s, dearest over cheapest {:.2f}\n", scene.name, poses,
               cheapest, dearest, dearest / cheapest);
    return dearest / cheapest;
}

int report_of(const Status& status) { return status ? 0 : report(status.error()); }

int run_frames(const Options& options) {
    const auto size = parse_size(options.size);
    if (!size) return report(size.error());
    if (options.effects)
        return report_of(bench_effects(options.context, size->width, size->height, options.frames, options.json));
    auto session = open_session(options.context);
    if (!session) return report(session.error());
    Bench bench{std::move(*session), std::make_unique<Renderer>(),
                gl::make_target(size->width, size->height, gl::Format::kRgba8)};
    std::vector<JsonObject> rows;
    for (const std::string& name : options.scenes) {
        auto scene = load_scene(name);
        if (!scene) return report(scene.error());
        scene->camera.width = size->width;
        scene->camera.height = size->height;
        auto row = measure(bench, *scene, options.frames);
        if (!row) return report(row.error());
        if (options.poses > 0) {
            const auto ratio = pose_ratio(bench, *scene, options.poses);
            if (!ratio) return report(ratio.error());
            row->add("pose_ratio", *ratio);
        }
        rows.push_back(std::move(*row));
    }
    if (options.json.empty()) return 0;
    if (Status written = write_text_atomically(options.json, json_list(rows)); !written) return report(written.error());
    return 0;
}

}  // namespace

void add_bench_frames(Command& bench) {
    auto options = std::make_shared<Options>();
    Command& command =
        bench.add_command("frames", "Time of a frame, in ratio to the same frame in flat space and to a bare fetch");
    command.add_option("scenes", &options->scenes, "Scenes to time").show_default();
    command.add_option("--size", &options->size, "Frame size, WIDTHxHEIGHT").show_default();
    context_option(command, options->context);
    command.add_option("--frames", &options->frames, "Frames of each kind").in_range(9, 10000).show_default();
    command.add_option("--poses", &options->poses, "Also time this many random camera poses of each scene")
        .in_range(0, 10000);
    command.add_flag("--effects", &options->effects,
                     "Instead of scenes: the empty scene, and each effect added to it alone");
    command.add_option("--json", &options->json, "Write the rows to this file");
    command.on_run([options] { return run_frames(*options); });
}

}  // namespace nullscope::cli
