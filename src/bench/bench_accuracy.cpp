// nullscope bench accuracy: error and cost of every method and table size, about a rotating hole of every step and order, in one run, costs drawn in turn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "base/progress.h"
#include "base/text.h"
#include "bench/bench.h"
#include "command/exact_trace.h"
#include "command/json.h"
#include "compare/ray_metrics.h"
#include "compare/remembered_trace.h"
#include "reference/reference.h"
#include "render/frontier.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options : BenchOptions {
    Options() { scenes = {"sky-only"}, frames = 9; }
    std::string plot, frontier;
};

constexpr double k4kWidth = 3840;
constexpr int kErrorWidth = 384, kErrorHeight = 216;  // a 4K frame of 90 degrees, every tenth pixel each way
constexpr int kSpinErrorWidth = 160,
              kSpinErrorHeight = 90;      // every 24th: the reference takes steps about a rotating hole
constexpr double kRefineAbove_px = 5e-5;  // of this frame: 0.0005 px of the 4K frame
constexpr double kNear = 1.5;             // horizon radii: nearer cameras about a rotating hole are reported apart
constexpr int kTimeWidth = 1280, kTimeHeight = 720;

constexpr std::string_view kMethods =
    "strip strip:cubic table:32:hermite table:64:hermite table:128:hermite table:256:hermite "
    "table:32:cubic table:64:cubic table:128:cubic table:256:cubic "
    "table:64:bilinear table:128:bilinear table:256:bilinear table:512:bilinear table:1024:bilinear "
    "table:64:hardware table:128:hardware table:256:hardware table:512:hardware table:1024:hardware closed-form "
    "integrate:6:1 integrate:6:0.6 integrate:6:0.3 integrate:6:0.2 integrate:6:0.15 "
    "integrate:4:0.4 integrate:4:0.2 integrate:4:0.1 integrate:4:0.05 euler:100 euler:300 euler:1000 euler:3000 "
    "mino:6:1 mino:6:0.8 mino:6:0.6 mino:6:0.45 mino:6:0.3 mino:4:0.6 mino:4:0.3 mino:4:0.15 mino:4:0.075 "
    "kerr-schild:0.32 kerr-schild:0.16 kerr-schild:0.08 kerr-schild:0.04 kerr-schild:0.02 kerr-schild:0.01";

struct Row {
    std::string name;
    Method method;
    std::vector<float> screen, forward, disc, near;  // per pixel; near: of cameras of kNear, which are not in screen
    long long fate_errors = 0, near_fate_errors = 0;
    long long steps = 0, rays = 0;  // of methods that count them
    int most_steps = 0;
    std::size_t bytes = 0;
    double build_ms = 0;
    Samples cost;
    Spread screen_px, forward_rad, disc_px, near_px;  // on the sky; places on the disc; on the sky of near cameras
    bool on_frontier = false;

    double core_s() const { return median(cost.core_s); }
};

bool is_default(const Method& method) { return method == Method{} || method == Method{.kind = MethodKind::kMino}; }

// Cameras far, in the middle, near, on the photon sphere, inside it, next to the horizon, and fast: each sees the whole
// sky, and then a disc that covers as much of it as a disc can. About a rotating hole, the sky alone, which all methods
// draw, of observers without angular momentum: far, middle, near, by the axis, at the photon orbits, in the ergosphere
// and next to the horizon.
std::vector<Scene> views(const SpacetimeSpec& spec, const Spacetime& spacetime) {
    struct Place {
        double r, theta, yaw, outward = 0, east = 0;  // the last two: velocity
    };
    const bool spins = !spacetime.planar_rays();
    const double horizon = spins ? *spacetime.horizon_radius() : 0.0;
    const std::vector<Place> still{{1000, 1.2, 0},          {1000, 1.2, 2},   {20, 1.2, 0},
                                   {20, 1.2, M_PI},         {3, 1.2, 0.7},    {1.5, 1.2, 1.2},
                                   {1.2, 1.2, 2.4},         {1.01, 1.2, 2.9}, {10, 1.2, 0.3, -0.5, 0.74},
                                   {10, 1.2, 1.0, 0.9, 0.3}};
    const std::vector<Place> spun{{1000, 1.2, 0}, {20, 1.2, 0},  {20, 1.2, M_PI},           {8, 1.5, 0},
                                  {4, 0.05, 0.3}, {2, 1.2, 0.7}, {1.3 * horizon, 1.4, 2.4}, {1.02 * horizon, 1.0, 2.4}};
    std::vector<Scene> list;
    for (const bool disc : {false, true})
        for (const Place& place : spins ? spun : still) {
            if (spins && disc) continue;
            Scene& scene = list.emplace_back();
            CameraSpec& camera = scene.camera;
            scene.spacetime = spec;
            scene.sky.kind = SkyKind::kBlack;
            if (disc) scene.disc = DiscSpec{};
            if (disc) scene.disc->inner = 1.5, scene.disc->outer = std::fmax(30, 3 * place.r);
            camera.observer = spins ? ObserverKind::kZamo : ObserverKind::kStatic;
            camera.r = place.r, camera.theta = place.theta, camera.yaw = place.yaw, camera.pitch = 0.1;
            camera.velocity = {place.outward, 0.0, place.east};
            camera.plane_width = 2.0;
            camera.width = spins ? kSpinErrorWidth : kErrorWidth;
            camera.height = spins ? kSpinErrorHeight : kErrorHeight;
        }
    return list;
}

// near_radius: nearer cameras are reported apart.
Status measure_errors(Renderer& renderer, const std::vector<Scene>& scenes, double near_radius,
                      std::vector<Row>& rows) {
    Progress progress("errors", static_cast<long long>(rows.size() * scenes.size()));
    for (const Scene& scene : scenes) {
        // A non-rotating hole's exact ray costs less than to look it up.
        const bool spins = light_path_kind(effect_set(required_effects(scene))) == LightPathKind::kMino;
        const ExactTrace trace = spins ? remembered(exact_trace(scene)) : exact_trace(scene);
        const bool near = scene.camera.r < near_radius;
        const auto to_4k = static_cast<float>(k4kWidth / scene.camera.width);
        for (Row& row : rows) {
            renderer.set_method(row.method);
            TRY(ready, renderer.prepare(scene));
            const RayFrame frame = renderer.ray_data();
            for (const RayPixel& pixel : frame.pixels)
                row.steps += pixel.steps, row.most_steps = std::max(row.most_steps, pixel.steps);
            row.rays += static_cast<long long>(frame.pixels.size());
            const RayMeasures m = measure_rays(frame, scene.camera, trace, 1, kRefineAbove_px);
            for (const PixelErrors& pixel : m.pixels) {
                if (pixel.hit) row.disc.push_back(pixel.place_px * to_4k);
                if (!pixel.escaped || scene.disc) continue;
                (near ? row.near : row.screen).push_back(pixel.sky_px * to_4k);
                row.forward.push_back(pixel.forward_rad);
            }
            (near ? row.near_fate_errors : row.fate_errors) += m.fate_errors;
            progress.advance();
        }
    }
    for (Row& row : rows)
        row.screen_px = spread_of(row.screen), row.forward_rad = spread_of(row.forward),
        row.disc_px = spread_of(row.disc), row.near_px = spread_of(row.near);
    return Done{};
}

// The bench's other renderer draws the floor: the scene in flat space.
Status measure_costs(const Bench& bench, Scene scene, int frames, std::vector<Row>& rows, Samples& floor) {
    scene.camera.width = kTimeWidth, scene.camera.height = kTimeHeight;
    Scene flat = scene;
    flat.spacetime = {"minkowski", {}};
    flat.camera.zoom.reset();
    TRY(flat_ready, bench.other->prepare(flat));
    bench.draw(*bench.other);
    Renderer& renderer = bench.renderer();
    Progress progress("costs", static_cast<long long>(rows.size()) * (frames + 1));
    for (int frame = -1; frame < frames; ++frame) {  // the first round compiles
        for (Row& row : rows) {
            renderer.set_method(row.method);
            TRY(ready, renderer.prepare(scene));
            if (frame < 0) {
                const bool strip = row.method.kind == MethodKind::kStrip;
                if (strip || row.method.kind == MethodKind::kTable) {
                    const auto& path = renderer.tables().path();
                    row.build_ms = path.table_ms + (strip ? path.rows_ms : renderer.gpu_table_ms());
                    for (const auto& line : renderer.textures())
                        if (line.name == (strip ? "strip" : "deflection table")) row.bytes = line.bytes;
                }
                bench.draw(renderer);
            } else {
                time_one(row.cost, [&] { bench.draw(renderer); });
            }
            progress.advance();
        }
        if (frame >= 0) time_one(floor, [&] { bench.draw(*bench.other); });
    }
    return Done{};
}

Json json_of(const Spread& s) { return {{"max", s.max}, {"p999", s.p999}, {"median", s.median}}; }

double mean_steps(const Row& row) { return static_cast<double>(row.steps) / static_cast<double>(row.rays); }

Json json_of(const Row& row, const Bench& bench, const std::string& metric, double floor_core) {
    const bool table = row.method.kind == MethodKind::kTable;
    Json o{{"method", row.name},
           {"size", table ? row.method.size : 0},
           {"lookup", table ? row.name.substr(row.name.rfind(':') + 1) : ""},
           {"metric", metric},
           {"bytes", row.bytes},
           {"build_ms", row.build_ms},
           {"core_seconds", row.core_s()},
           {"median_ms", median(row.cost.wall_ms)},
           {"floor_ratio", row.core_s() / floor_core},
           {"screen_error_px", json_of(row.screen_px)},
           {"forward_error_rad", json_of(row.forward_rad)},
           {"disc_error_px", json_of(row.disc_px)},
           {"fate_errors", row.fate_errors},
           {"on_frontier", row.on_frontier}};
    if (counts_steps(row.method)) {
        o["mean_steps"] = mean_steps(row), o["most_steps"] = row.most_steps;
        o["near_error_px"] = json_of(row.near_px), o["near_fate_errors"] = row.near_fate_errors;
    }
    o["is_default"] = is_default(row.method);
    o["context"] = bench.session.context->kind(), o["renderer"] = bench.driver();
    o["width"] = kTimeWidth, o["height"] = kTimeHeight, o["threads"] = std::thread::hardware_concurrency();
    return o;
}

const char* place_of(const Row& row) {
    return is_default(row.method) ? "default" : row.on_frontier ? "frontier" : "dominated";
}

void print_table(const std::vector<Row>& rows, double floor_core) {
    fmt::print(
        "| method | bytes | build ms | core-s | x floor | screen error px: max | 99.9 % | median | on a disc: max | "
        "forward error rad: max | median | fate errors | |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows)
        fmt::print(
            "| {} | {} | {:.1f} | {:.4f} | {:.2f} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {} | {} |\n",
            row.name, row.bytes, row.build_ms, row.core_s(), row.core_s() / floor_core, row.screen_px.max,
            row.screen_px.p999, row.screen_px.median, row.disc_px.max, row.forward_rad.max, row.forward_rad.median,
            row.fate_errors, place_of(row));
}

// About a rotating hole: no tables, no discs, but steps.
void print_spin_table(const std::vector<Row>& rows, double floor_core) {
    const auto own = std::ranges::find_if(rows, is_default, &Row::method);
    fmt::print(
        "| method | screen error px: max | 99.9 % | median | fate errors | next to the horizon: max | 99.9 % | fate "
        "errors | steps: mean | most | core-s | x floor | x default | |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows)
        fmt::print(
            "| {} | {:.2g} | {:.2g} | {:.2g} | {} | {:.2g} | {:.2g} | {} | {:.2f} | {} | {:.4f} | {:.2f} | {:.2f} | {} "
            "|\n",
            row.name, row.screen_px.max, row.screen_px.p999, row.screen_px.median, row.fate_errors, row.near_px.max,
            row.near_px.p999, row.near_fate_errors, mean_steps(row), row.most_steps, row.core_s(),
            row.core_s() / floor_core, row.core_s() / own->core_s(), place_of(row));
}

// What every method for rotating holes draws: the sky, and no time to pass.
Scene sky_alone(const Scene& scene) {
    Scene alone;
    alone.name = scene.name, alone.spacetime = scene.spacetime, alone.camera = scene.camera, alone.sky = scene.sky;
    return alone;
}

Status run(const Options& options) {
    TRY(bench, open_bench(options.context, kTimeWidth, kTimeHeight));
    Json objects = Json::array();
    std::vector<MeasuredMethod> measured;
    for (const std::string& name : options.scenes) {
        TRY(scene, load_scene(name));
        const EffectSet effects = effect_set(required_effects(*scene));
        const bool spins = light_path_kind(effects) == LightPathKind::kMino;
        if (!effects.contains(Effect::kLensing) && !spins)
            return bad_input(fmt::format("scene {}: light runs straight in {}, there is nothing to compare", name,
                                         scene->spacetime.metric));
        TRY(spacetime, make_spacetime(scene->spacetime.metric, scene->spacetime.parameters));
        std::vector<Row> rows;
        for (const std::string& text : split(kMethods, ' ')) {
            TRY(method, parse_method(text));
            if (!has_method(**spacetime, *method)) continue;
            Row& row = rows.emplace_back();
            row.name = text, row.method = *method;
        }
        Samples floor;
        const std::vector<Scene> scenes = views(scene->spacetime, **spacetime);
        const double near_radius = spins ? kNear * *(*spacetime)->horizon_radius() : 0.0;
        TRY(errors, measure_errors(bench->renderer(), scenes, near_radius, rows));
        TRY(costs, measure_costs(*bench, spins ? sky_alone(*scene) : *scene, options.frames, rows, floor));
        const double floor_core = median(floor.core_s);
        std::vector<MeasuredMethod> all;
        all.reserve(rows.size());
        for (const Row& row : rows)
            all.push_back(
                {scene->spacetime.metric, row.method, row.screen_px.max, row.core_s() / floor_core, row.disc_px.max});
        if (!spins) measured.insert(measured.end(), all.begin(), all.end());
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].on_frontier = !is_dominated(all[i], all);
        (spins ? print_spin_table : print_table)(rows, floor_core);
        std::vector<PlotPoint> points;
        for (const Row& row : rows) {
            objects.push_back(json_of(row, *bench, scene->spacetime.metric, floor_core));
            points.push_back(
                {row.name, row.method, row.core_s(), row.screen_px.max, row.on_frontier, is_default(row.method)});
        }
        if (options.plot.empty()) continue;
        const std::string subtitle = fmt::format(
            "{}, {}, {}, {} threads; {} cameras, every {}th pixel of a 4K frame; grey: dominated",
            scene->spacetime.metric, bench->session.context->kind(), bench->driver(),
            std::thread::hardware_concurrency(),
            std::ranges::count_if(scenes, [&](const Scene& s) { return !s.disc && s.camera.r >= near_radius; }),
            k4kWidth / scenes.front().camera.width);
        TRY(plotted, write_text_atomically(options.plot, accuracy_svg(points, floor_core, subtitle)));
    }
    if (!options.frontier.empty()) {
        TRY(written, write_text_atomically(options.frontier, frontier_text(measured)));
    }
    return write_json(options.json, objects);
}

}  // namespace

void add_bench_accuracy(Command& bench) {
    auto [command, options] =
        add_command<Options>(bench, "accuracy",
                             "Error and cost of every tracing method, for a rotating hole of its step "
                             "sizes and orders, as a table, a diagram and JSON; some minutes",
                             run);
    command.add_option("scenes", &options.scenes, "Scenes whose spacetime and sky are used").show_default();
    context_option(command, options.context);
    number_option(command, "--frames", options.frames, 3, 1000, "Timed frames of each method");
    json_option(command, options);
    command.add_option("--plot", &options.plot, "Write the work-precision diagram to this SVG file");
    command.add_option(
        "--frontier", &options.frontier,
        "Write the methods that --method auto chooses from to this CSV file (built in: assets/frontier.csv)");
}

}  // namespace nullscope::cli
