// nullscope bench accuracy: error and cost of every method and table size, about a rotating hole of every step and order, in one run, costs drawn in turn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/accuracy_plot.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/remembered_trace.h"
#include "cli/session.h"
#include "compare/ray_metrics.h"
#include "reference/reference.h"
#include "render/frontier.h"
#include "scene/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::vector<std::string> scenes = {"sky-only"};
    std::string context = "auto", json, plot, frontier;
    int frames = 9;
};

constexpr double k4kWidth = 3840;
constexpr int kErrorWidth = 384, kErrorHeight = 216;  // a 4K frame of 90 degrees, every tenth pixel each way
constexpr int kSpinErrorWidth = 160,
              kSpinErrorHeight = 90;      // the same, every 24th: the reference takes steps about a rotating hole
constexpr double kRefineAbove_px = 5e-5;  // of this frame: 0.0005 px of the 4K frame
constexpr double kNear = 1.5;             // horizon radii: nearer cameras about a rotating hole are reported apart
constexpr int kTimeWidth = 1280, kTimeHeight = 720;

const std::vector<std::string>& methods() {
    static const std::vector<std::string> list = {"strip",
                                                  "strip:cubic",
                                                  "table:32:hermite",
                                                  "table:64:hermite",
                                                  "table:128:hermite",
                                                  "table:256:hermite",
                                                  "table:32:cubic",
                                                  "table:64:cubic",
                                                  "table:128:cubic",
                                                  "table:256:cubic",
                                                  "table:64:bilinear",
                                                  "table:128:bilinear",
                                                  "table:256:bilinear",
                                                  "table:512:bilinear",
                                                  "table:1024:bilinear",
                                                  "table:64:hardware",
                                                  "table:128:hardware",
                                                  "table:256:hardware",
                                                  "table:512:hardware",
                                                  "table:1024:hardware",
                                                  "closed-form",
                                                  "integrate:6:1",
                                                  "integrate:6:0.6",
                                                  "integrate:6:0.3",
                                                  "integrate:6:0.2",
                                                  "integrate:6:0.15",
                                                  "integrate:4:0.4",
                                                  "integrate:4:0.2",
                                                  "integrate:4:0.1",
                                                  "integrate:4:0.05",
                                                  "euler:100",
                                                  "euler:300",
                                                  "euler:1000",
                                                  "euler:3000",
                                                  "mino:6:1",
                                                  "mino:6:0.8",
                                                  "mino:6:0.6",
                                                  "mino:6:0.45",
                                                  "mino:6:0.3",
                                                  "mino:4:0.6",
                                                  "mino:4:0.3",
                                                  "mino:4:0.15",
                                                  "mino:4:0.075",
                                                  "kerr-schild:0.32",
                                                  "kerr-schild:0.16",
                                                  "kerr-schild:0.08",
                                                  "kerr-schild:0.04",
                                                  "kerr-schild:0.02",
                                                  "kerr-schild:0.01"};
    return list;
}

// Far, middle, near, on the photon sphere, inside it, next to the horizon, and fast.
std::vector<CameraSpec> cameras() {
    std::vector<CameraSpec> list;
    const auto add = [&](double r, double yaw, Vec3 velocity) {
        CameraSpec camera;
        camera.r = r;
        camera.theta = 1.2;
        camera.yaw = yaw;
        camera.pitch = 0.1;
        camera.velocity = velocity;
        camera.plane_width = 2.0;
        camera.width = kErrorWidth;
        camera.height = kErrorHeight;
        list.push_back(camera);
    };
    add(1000, 0, {}), add(1000, 2, {});
    add(20, 0, {}), add(20, M_PI, {});
    add(3, 0.7, {}), add(1.5, 1.2, {}), add(1.2, 2.4, {}), add(1.01, 2.9, {});
    add(10, 0.3, {-0.5, 0.0, 0.74}), add(10, 1.0, {0.9, 0.0, 0.3});
    return list;
}

// Of observers without angular momentum: far, middle, near, by the axis, at the photon orbits, in the ergosphere and next to the horizon.
std::vector<CameraSpec> spin_cameras(double horizon) {
    std::vector<CameraSpec> list;
    const auto add = [&](double r, double theta, double yaw) {
        CameraSpec camera;
        camera.observer = ObserverKind::kZamo;
        camera.r = r, camera.theta = theta, camera.yaw = yaw, camera.pitch = 0.1;
        camera.plane_width = 2.0;
        camera.width = kSpinErrorWidth, camera.height = kSpinErrorHeight;
        list.push_back(camera);
    };
    add(1000, 1.2, 0), add(20, 1.2, 0), add(20, 1.2, M_PI), add(8, 1.5, 0), add(4, 0.05, 0.3), add(2, 1.2, 0.7),
        add(1.3 * horizon, 1.4, 2.4), add(1.02 * horizon, 1.0, 2.4);
    return list;
}

struct Row {
    std::string name;
    Method method;
    std::vector<float> screen, forward, disc,
        near;  // per pixel of all cameras; near: those of kNear, which are not in screen
    long long fate_errors = 0, near_fate_errors = 0;
    long long steps = 0, rays = 0;  // of methods that count them
    int most_steps = 0;
    std::size_t bytes = 0;
    double build_ms = 0;
    Samples cost;
    Spread screen_px, forward_rad, disc_px, near_px;  // on the sky; places on the disc; on the sky of near cameras
    bool on_frontier = false;
};

bool is_default(const Method& method) { return method == Method{} || method == Method{.kind = MethodKind::kMino}; }

// Each camera sees the whole sky, and then a disc that covers as much of it as a disc can; about a rotating hole the sky alone, which every method draws.
std::vector<Scene> views(const SpacetimeSpec& spec, const Spacetime& spacetime) {
    std::vector<Scene> list;
    const bool spins = !spacetime.planar_rays();
    for (const bool disc : {false, true})
        for (const CameraSpec& camera : spins ? spin_cameras(*spacetime.horizon_radius()) : cameras()) {
            if (spins && disc) continue;
            Scene scene;
            scene.spacetime = spec;
            scene.camera = camera;
            scene.sky.kind = SkyKind::kBlack;
            if (disc) {
                scene.disc.emplace();
                scene.disc->inner = 1.5;
                scene.disc->outer = std::fmax(30, 3 * camera.r);
            }
            list.push_back(std::move(scene));
        }
    return list;
}

// near_radius: nearer cameras are reported apart.
Status measure_errors(Session& session, const std::vector<Scene>& scenes, double near_radius, std::vector<Row>& rows) {
    Progress progress("errors", static_cast<long long>(rows.size() * scenes.size()));
    for (const Scene& scene : scenes) {
        const ExactTrace plain = [&](const std::vector<std::array<double, 2>>& positions) {
            auto pixels = reference::trace_pixels(scene, positions);
            return pixels ? std::move(*pixels) : std::vector<RayPixel>(positions.size());
        };
        // A non-rotating hole's exact ray costs less than to look it up.
        const ExactTrace trace = light_path_kind(effect_set(required_effects(scene))) == LightPathKind::kMino
                                     ? remembered_trace(scene)
                                     : plain;
        const bool near = scene.camera.r < near_radius;
        const auto to_4k = static_cast<float>(k4kWidth / scene.camera.width);
        for (Row& row : rows) {
            session.renderer->set_method(row.method);
            if (Status ready = session.renderer->prepare(scene); !ready) return ready;
            const RayFrame frame = session.renderer->ray_data();
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

Status measure_costs(Session& session, Scene scene, int frames, std::vector<Row>& rows, Samples& floor) {
    scene.camera.width = kTimeWidth;
    scene.camera.height = kTimeHeight;
    Scene flat = scene;
    flat.spacetime = {"minkowski", {}};
    Renderer flat_renderer;
    if (Status ready = flat_renderer.prepare(flat); !ready) return ready;
    const gl::Target target = gl::make_target(kTimeWidth, kTimeHeight, gl::Format::kRgba8);
    const auto draw = [&](Renderer& renderer) {
        renderer.draw(target.framebuffer.id(), kTimeWidth, kTimeHeight, Output::kDisplay);
    };
    draw(flat_renderer);
    Progress progress("costs", static_cast<long long>(rows.size()) * (frames + 1));
    for (int frame = -1; frame < frames; ++frame) {  // the first round compiles
        for (Row& row : rows) {
            session.renderer->set_method(row.method);
            if (Status ready = session.renderer->prepare(scene); !ready) return ready;
            if (frame < 0) {
                row.build_ms =
                    session.renderer->tables().path().table_ms +
                    (row.method.kind == MethodKind::kTable ? session.renderer->gpu_table_ms() : 0.0) +
                    (row.method.kind == MethodKind::kStrip ? session.renderer->tables().path().rows_ms : 0.0);
                for (const auto& line : session.renderer->textures())
                    if (line.name == (row.method.kind == MethodKind::kStrip ? "strip" : "deflection table"))
                        row.bytes = line.bytes;
                if (row.method.kind != MethodKind::kStrip && row.method.kind != MethodKind::kTable)
                    row.build_ms = 0, row.bytes = 0;
                draw(*session.renderer);
            } else {
                time_one(row.cost, [&] { draw(*session.renderer); });
            }
            progress.advance();
        }
        if (frame >= 0) time_one(floor, [&] { draw(flat_renderer); });
    }
    return Done{};
}

void mark_frontier(std::vector<Row>& rows) {
    for (Row& row : rows) {
        row.on_frontier = std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
            const double c = median(other.cost.core_s), mine = median(row.cost.core_s);
            return c <= mine && other.screen_px.max <= row.screen_px.max &&
                   (c < mine || other.screen_px.max < row.screen_px.max);
        });
    }
}

std::string spread_json(const Spread& s) {
    return JsonObject().add("max", s.max).add("p999", s.p999).add("median", s.median).text();
}

const char* lookup_name(Lookup lookup) {
    switch (lookup) {
        case Lookup::kHardware: return "hardware";
        case Lookup::kBilinear: return "bilinear";
        case Lookup::kCubic: return "cubic";
        case Lookup::kHermite: return "hermite";
    }
    return "";
}

double mean_steps(const Row& row) { return static_cast<double>(row.steps) / static_cast<double>(row.rays); }

JsonObject json_of(const Row& row, const Session& session, const std::string& metric, double floor_core) {
    const double core = median(row.cost.core_s);
    const bool table = row.method.kind == MethodKind::kTable;
    JsonObject o;
    o.add("method", row.name)
        .add("size", table ? row.method.size : 0)
        .add("lookup", table ? lookup_name(row.method.lookup) : "");
    o.add("metric", metric).add("bytes", static_cast<long long>(row.bytes)).add("build_ms", row.build_ms);
    o.add("core_seconds", core).add("median_ms", median(row.cost.wall_ms)).add("floor_ratio", core / floor_core);
    o.raw("screen_error_px", spread_json(row.screen_px)).raw("forward_error_rad", spread_json(row.forward_rad));
    o.raw("disc_error_px", spread_json(row.disc_px));
    o.add("fate_errors", row.fate_errors).raw("on_frontier", row.on_frontier ? "true" : "false");
    if (counts_steps(row.method)) {
        o.add("mean_steps", mean_steps(row)).add("most_steps", row.most_steps);
        o.raw("near_error_px", spread_json(row.near_px)).add("near_fate_errors", row.near_fate_errors);
    }
    o.raw("is_default", is_default(row.method) ? "true" : "false");
    o.add("context", session.context->kind()).add("renderer", session.renderer->info().renderer);
    o.add("width", kTimeWidth)
        .add("height", kTimeHeight)
        .add("threads", static_cast<int>(std::thread::hardware_concurrency()));
    return o;
}

std::string family(const Method& method) {
    if (method.kind == MethodKind::kIntegrate) return method.order == 1 ? "euler" : "integrate";
    if (method.kind == MethodKind::kMino) return method.order == 4 ? "mino:4" : "mino:6";
    const std::string name = method_name(method);
    return name.substr(0, name.find(':'));
}

const char* place_of(const Row& row) {
    return is_default(row.method) ? "default" : row.on_frontier ? "frontier" : "dominated";
}

void print_table(const std::vector<Row>& rows, double floor_core) {
    fmt::print(
        "| method | bytes | build ms | core-s | x floor | screen error px: max | 99.9 % | median | on a disc: max | "
        "forward error rad: max | median | fate errors | |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows) {
        const double core = median(row.cost.core_s);
        fmt::print(
            "| {} | {} | {:.1f} | {:.4f} | {:.2f} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {} | {} |\n",
            row.name, row.bytes, row.build_ms, core, core / floor_core, row.screen_px.max, row.screen_px.p999,
            row.screen_px.median, row.disc_px.max, row.forward_rad.max, row.forward_rad.median, row.fate_errors,
            place_of(row));
    }
}

// About a rotating hole: no tables, no discs, but steps.
void print_spin_table(const std::vector<Row>& rows, double floor_core) {
    const auto own = std::find_if(rows.begin(), rows.end(), [](const Row& row) { return is_default(row.method); });
    fmt::print(
        "| method | screen error px: max | 99.9 % | median | fate errors | next to the horizon: max | 99.9 % | fate "
        "errors | steps: mean | most | core-s | x floor | x default | |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows) {
        const double core = median(row.cost.core_s);
        fmt::print(
            "| {} | {:.2g} | {:.2g} | {:.2g} | {} | {:.2g} | {:.2g} | {} | {:.2f} | {} | {:.4f} | {:.2f} | {:.2f} | {} "
            "|\n",
            row.name, row.screen_px.max, row.screen_px.p999, row.screen_px.median, row.fate_errors, row.near_px.max,
            row.near_px.p999, row.near_fate_errors, mean_steps(row), row.most_steps, core, core / floor_core,
            core / median(own->cost.core_s), place_of(row));
    }
}

// What every method for rotating holes draws: the sky, and no time to pass.
Scene sky_alone(const Scene& scene) {
    Scene alone;
    alone.name = scene.name, alone.spacetime = scene.spacetime, alone.camera = scene.camera, alone.sky = scene.sky;
    return alone;
}

int run(const Options& options) {
    auto session = open_session(options.context);
    if (!session) return report(session.error());
    std::vector<JsonObject> objects;
    std::vector<MeasuredMethod> measured;
    for (const std::string& name : options.scenes) {
        auto scene = load_scene(name);
        if (!scene) return report(scene.error());
        const EffectSet effects = effect_set(required_effects(*scene));
        const bool spins = light_path_kind(effects) == LightPathKind::kMino;
        if (!effects.contains(Effect::kLensing) && !spins)
            return report(bad_input(fmt::format("scene {}: light runs straight in {}, there is nothing to compare",
                                                name, scene->spacetime.metric)));
        const auto spacetime = make_spacetime(scene->spacetime.metric, scene->spacetime.parameters);
        if (!spacetime) return report(spacetime.error());
        std::vector<Row> rows;
        for (const std::string& text : methods()) {
            const auto method = parse_method(text);
            if (!method) return report(method.error());
            if (!has_method(**spacetime, *method)) continue;
            Row row;
            row.name = text;
            row.method = *method;
            rows.push_back(std::move(row));
        }
        Samples floor;
        const std::vector<Scene> scenes = views(scene->spacetime, **spacetime);
        const double near_radius = spins ? kNear * *(*spacetime)->horizon_radius() : 0.0;
        if (Status done = measure_errors(*session, scenes, near_radius, rows); !done) return report(done.error());
        if (Status done = measure_costs(*session, spins ? sky_alone(*scene) : *scene, options.frames, rows, floor);
            !done)
            return report(done.error());
        mark_frontier(rows);
        const double floor_core = median(floor.core_s);
        (spins ? print_spin_table : print_table)(rows, floor_core);
        std::vector<PlotPoint> points;
        for (const Row& row : rows) {
            if (!spins)
                measured.push_back({scene->spacetime.metric, row.method, row.screen_px.max,
                                    median(row.cost.core_s) / floor_core, row.disc_px.max});
            objects.push_back(json_of(row, *session, scene->spacetime.metric, floor_core));
            points.push_back({row.name, family(row.method), median(row.cost.core_s), row.screen_px.max, row.on_frontier,
                              is_default(row.method)});
        }
        if (options.plot.empty()) continue;
        const std::string subtitle =
            fmt::format("{}, {}, {}, {} threads; {} cameras, every {}th pixel of a 4K frame; grey: dominated",
                        scene->spacetime.metric, session->context->kind(), session->renderer->info().renderer,
                        std::thread::hardware_concurrency(),
                        std::count_if(scenes.begin(), scenes.end(),
                                      [&](const Scene& s) { return !s.disc && s.camera.r >= near_radius; }),
                        k4kWidth / scenes.front().camera.width);
        if (Status written = write_text_atomically(options.plot, accuracy_svg(points, floor_core, subtitle)); !written)
            return report(written.error());
    }
    if (!options.frontier.empty())
        if (Status written = write_text_atomically(options.frontier, frontier_text(measured)); !written)
            return report(written.error());
    if (options.json.empty()) return 0;
    if (Status written = write_text_atomically(options.json, json_list(objects)); !written)
        return report(written.error());
    return 0;
}

}  // namespace

void add_bench_accuracy(Command& bench) {
    auto options = std::make_shared<Options>();
    Command& command = bench.add_command("accuracy",
                                         "Error and cost of every way of tracing, about a rotating hole of its steps "
                                         "and orders, as a table, a diagram and JSON; some minutes");
    command.add_option("scenes", &options->scenes, "Scenes whose spacetime and sky are used").show_default();
    context_option(command, options->context);
    command.add_option("--frames", &options->frames, "Timed frames of each method").in_range(3, 1000).show_default();
    command.add_option("--json", &options->json, "Write the rows to this file");
    command.add_option("--plot", &options->plot, "Write the work-precision diagram to this SVG file");
    command.add_option("--frontier", &options->frontier,
                       "Write what --method auto chooses from to this CSV file (ships as assets/frontier.csv)");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
