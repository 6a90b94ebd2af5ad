// nullscope bench frames: what a frame costs, against the same frame in flat space and against one bare fetch of the sky a pixel,
// drawn in turn (A B C A B C ...) so that a noisy machine does not decide.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "bench/bench.h"
#include "command/arguments.h"
#include "command/json.h"
#include "command/stage_choice.h"
#include "spacetime/minkowski.h"

namespace nullscope::cli {
namespace {

struct FramesBench : BenchOptions {
    FramesBench() { scenes = {"flat", "sky-only", "first-light"}; }
    int poses = 0;
    bool effects = false, moving = false, refined = false;
    std::string stage = kFragmentStage;
};

// What a row of any measurement begins with.
Json row_of(const Bench& bench, const Scene& scene, int frames) {
    return {{"scene", scene.name},           {"context", bench.session.context->kind()},
            {"renderer", bench.driver()},    {"width", bench.target.width},
            {"height", bench.target.height}, {"frames", frames}};
}

// The bench's other renderer draws the floor: the scene in flat space.
Result<Json> measure(const Bench& bench, const Scene& scene, int frames) {
    Scene flat = scene;
    flat.spacetime = {"minkowski", {}};
    flat.camera.zoom.reset();
    if (!camera_can_rest(Minkowski{}, flat.camera.r)) flat.camera.r = 1.0;  // a wormhole's throat is no place there
    const Stopwatch prepare_watch;
    TRY(ready, bench.renderer().prepare(scene));
    gl::finish();
    const double prepare_ms = prepare_watch.ms();
    TRY(floor_ready, bench.other->prepare(flat));
    const Renderer& renderer = bench.renderer();
    const Stopwatch watch;
    bench.draw(bench.renderer());  // compiles
    gl::finish();
    const double first_ms = watch.ms();
    const auto fetch = [&] {
        bench.other->draw_bare_fetch(bench.target.framebuffer.id(), bench.target.width, bench.target.height);
    };
    Progress progress("bench " + scene.name, frames);
    const auto samples = bench.time_in_turn(frames, {fetch}, [&] { progress.advance(); });
    const std::vector<double>& wall_ms = samples[0].wall_ms;
    const auto [low, high] = std::minmax_element(wall_ms.begin(), wall_ms.end());
    const double core = median(samples[0].core_s), floor = median(samples[1].core_s),
                 table_ms = renderer.tables().path().table_ms + renderer.tables().path().rows_ms,
                 fetch_ratio = core / median(samples[2].core_s);
    fmt::print(
        "{:<18} {:7.2f} ms ({:.2f} to {:.2f})  {:.4f} core-s  {:5.2f} x floor  {:5.2f} x fetch  first frame {:.0f} ms, "
        "tables {:.1f} ms\n",
        scene.name, median(wall_ms), *low, *high, core, core / floor, fetch_ratio, first_ms, table_ms);
    Json row = row_of(bench, scene, frames);
    row.update(Json{{"median_ms", median(wall_ms)},
                    {"min_ms", *low},
                    {"max_ms", *high},
                    {"core_seconds", core},
                    {"gpu_ms", median(samples[0].gpu_ms)},
                    {"floor_gpu_ms", median(samples[1].gpu_ms)},
                    {"prepare_ms", prepare_ms},
                    {"compile_ms", first_ms},
                    {"table_ms", table_ms},
                    {"floor_ratio", core / floor},
                    {"fetch_ratio", fetch_ratio},
                    {"floor_core_seconds", floor}});
    return row;
}

// The picture at rest, whose edges have more rays, in turn with the one in flight.
Result<Json> refined_cost(const Bench& bench, const Scene& scene, int frames) {
    Scene refined = scene;
    refined.picture.refine = true;
    TRY(ready, bench.prepare(refined, scene));
    const auto samples = bench.time_in_turn(frames);
    const double core = median(samples[0].core_s), ratio = core / median(samples[1].core_s),
                 share = bench.renderer().refined_share();
    fmt::print("{:<18} edges refined: {:.4f} core-s, {:.2f} times, {:.1f} % of the pixels\n", scene.name, core, ratio,
               100.0 * share);
    return Json{{"refined_core_seconds", core}, {"refined_ratio", ratio}, {"refined_share", share}};
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
Result<double> pose_ratio(const Bench& bench, const Scene& scene, int poses) {
    std::mt19937 random(20151127);
    double cheapest = 1e30, dearest = 0.0;
    Progress progress("poses of " + scene.name, poses);
    for (int i = 0; i < poses; ++i, progress.advance()) {
        const Scene posed = random_pose(scene, random);
        TRY(ready, bench.renderer().prepare(posed));
        Samples samples;
        for (int k = 0; k < 3; ++k) time_one(samples, [&] { bench.draw(bench.renderer()); });
        const double cost = *std::min_element(samples.core_s.begin(), samples.core_s.end());
        cheapest = std::min(cheapest, cost);
        dearest = std::max(dearest, cost);
    }
    fmt::print("{:<18} {} random poses: {:.4f} to {:.4f} core-s, most over least expensive {:.2f}\n", scene.name, poses,
               cheapest, dearest, dearest / cheapest);
    return dearest / cheapest;
}

// What the host does before a frame whose camera came closer or went away, and the frame with it, in turn with those of a camera at rest.
Result<Json> moving_cost(const Bench& bench, const Scene& scene, int frames) {
    constexpr double kAway = 1e-3;  // of the radius, from frame to frame
    constexpr int kWarmUp = 6;      // frames that compile, and after which a flight's first tables are there
    Scene moved = scene;
    TRY(ready, bench.prepare(moved, scene));
    bench.renderer().draft(true);  // as the viewer does in motion
    struct Camera {
        Renderer& renderer;
        Samples host{}, frame{};
    };
    Camera moving{bench.renderer()}, rest{*bench.other};
    Status prepared = Done{};
    Progress progress("moving " + scene.name, frames + kWarmUp);
    for (int i = -kWarmUp; i < frames; ++i, progress.advance()) {
        moved.camera.r *= 1.0 + kAway;
        for (Camera* camera : {&moving, &rest}) {
            Samples host, frame;
            const Scene& next = camera == &moving ? moved : scene;
            time_one(frame, [&] {
                time_one(host, [&] { prepared = camera->renderer.prepare(next); });
                if (prepared) bench.draw(camera->renderer);
            });
            if (!prepared) return prepared.error();
            if (i < 0) continue;
            camera->host.core_s.push_back(host.core_s.front());
            camera->frame.core_s.push_back(frame.core_s.front());
        }
    }
    const auto milliseconds = [](const Samples& samples) { return 1e3 * median(samples.core_s); };
    // Some frames make tables for those that follow: the mean counts them.
    const auto mean = [](const Samples& samples) {
        return 1e3 * std::accumulate(samples.core_s.begin(), samples.core_s.end(), 0.0) /
               static_cast<double>(samples.core_s.size());
    };
    const double host = mean(moving.host), host_at_rest = mean(rest.host);
    const double frame = milliseconds(moving.frame), frame_at_rest = milliseconds(rest.frame);
    fmt::print(
        "{:<18} host {:.2f} core-ms, at rest {:.2f}: {:.2f} more; frame {:.2f} core-ms, at rest {:.2f}: {:.2f} times\n",
        scene.name, host, host_at_rest, host - host_at_rest, frame, frame_at_rest, frame / frame_at_rest);
    Json row = row_of(bench, scene, frames);
    row.update(Json{{"host_core_ms", host},
                    {"host_at_rest_core_ms", host_at_rest},
                    {"frame_core_ms", frame},
                    {"frame_at_rest_core_ms", frame_at_rest}});
    return row;
}

// What draws the scene's frames; said where it was not asked for by name.
Result<std::string> stage_of(const Bench& bench, const Scene& scene, const std::string& asked) {
    Renderer& renderer = bench.renderer();
    if (asked != "auto") {
        renderer.compute(asked == kComputeStage);
        return asked;
    }
    TRY(ready, renderer.prepare(scene));
    const StageChoice choice = choose_stage(renderer, bench.target.width, bench.target.height);
    fmt::print("{:<18} stage {}: {}\n", scene.name, choice.stage, choice.reason);
    return choice.stage;
}

Status run_frames(const FramesBench& options) {
    if (options.effects && (options.poses > 0 || options.moving || options.refined))
        return bad_input("--effects: of the empty scene, at rest", "without --poses, --moving and --refined");
    if (options.effects) return bench_effects(options);
    TRY(bench, open_bench(options));
    for (Renderer* renderer : {&bench->renderer(), bench->other.get()})
        renderer->limit_tiles(Tiles::kInterpolated), renderer->follow_camera();  // as the viewer does in flight
    Json rows = Json::array();
    for (const std::string& name : options.scenes) {
        TRY(scene, load_scene_sized(name, options.size));
        TRY(stage, stage_of(*bench, *scene, options.stage));
        const bool refines = effect_set(required_effects(*scene)).contains(Effect::kRefine);
        scene->picture.refine = false;  // as in flight
        TRY(row,
            options.moving ? moving_cost(*bench, *scene, options.frames) : measure(*bench, *scene, options.frames));
        if (refines && options.refined) {
            TRY(cost, refined_cost(*bench, *scene, options.frames));
            row->update(*cost);
        }
        if (options.poses > 0) {
            TRY(ratio, pose_ratio(*bench, *scene, options.poses));
            (*row)["pose_ratio"] = *ratio;
        }
        (*row)["stage"] = *stage;
        rows.push_back(std::move(*row));
    }
    return write_json(options.json, rows);
}

}  // namespace

void add_bench_frames(Command& bench) {
    auto [command, options] = add_command<FramesBench>(
        bench, "frames", "Time of a frame, relative to the same frame in flat space and to a bare texture fetch",
        run_frames);
    command.add_option("scenes", &options.scenes, "Scenes to time").show_default();
    draw_options(command, options, 9);
    text_option(command, "--stage", options.stage,
                "Shaders that trace the picture: fragment, compute (OpenGL 4.3), or auto: what a frame costs less by",
                {"fragment", "compute", "auto"});
    command.add_option("--poses", &options.poses, "Also time this many random camera poses of each scene")
        .in_range(0, 10000);
    command.add_flag(
        "--moving", &options.moving,
        "Instead: a frame in motion, of a camera whose radius changes, and what the host adds to it, beside one at "
        "rest; light of matter is interpolated to some per cent in motion, to 0.5 % at rest");
    command.add_flag("--refined", &options.refined,
                     "Also the picture at rest, whose edges have more rays, beside the one in flight");
    command.add_flag("--effects", &options.effects,
                     "Instead of scenes: the empty scene, and the empty scene with each effect added");
    json_option(command, options);
}

}  // namespace nullscope::cli
