// nullscope bench accuracy: error and cost of every method and table size, about a rotating hole of every step and order, a row as soon as
// it is measured.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "base/progress.h"
#include "bench/accuracy_rows.h"
#include "bench/spread_json.h"
#include "command/json.h"
#include "scenefile/scene_file.h"
#include "shaderlib/frontier.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options : BenchOptions {
    Options() { scenes = {"sky-only"}, frames = 7; }
    std::string plot, frontier;
    bool whole_frames = false;
};

using Row = AccuracyRow;

Json json_of(const Row& row, const Bench& bench, const std::string& metric) {
    const bool table = row.method.kind == MethodKind::kTable;
    Json o{{"method", row.name},
           {"size", table ? row.method.size : 0},
           {"lookup", table ? row.name.substr(row.name.rfind(':') + 1) : ""},
           {"metric", metric},
           {"bytes", row.bytes},
           {"build_ms", row.build_ms},
           {"core_seconds", row.core_s()},
           {"median_ms", median(row.cost.wall_ms)},
           {"floor_ratio", row.floor_ratio()},
           {"screen_error_px", spread_json(row.screen_px)},
           {"forward_error_rad", spread_json(row.forward_rad)},
           {"disc_error_px", spread_json(row.disc_px)},
           {"fate_errors", row.fate_errors},
           {"on_frontier", row.on_frontier}};
    if (counts_steps(row.method)) {
        o["mean_steps"] = row.mean_steps(), o["most_steps"] = row.most_steps;
        o["near_error_px"] = spread_json(row.near_px), o["near_fate_errors"] = row.near_fate_errors;
    }
    if (!row.whole.core_s.empty()) o["whole_frame_core_seconds"] = median(row.whole.core_s);
    o["is_default"] = row.is_default();
    o["context"] = bench.session.context->kind(), o["renderer"] = bench.driver();
    o["width"] = kTimeWidth, o["height"] = kTimeHeight, o["threads"] = std::thread::hardware_concurrency();
    return o;
}

void print_head(bool spins) {
    if (spins)  // no tables, no discs, but steps
        fmt::print(
            "| method | screen error px: max | 99.9 % | median | fate errors | next to the horizon: max | 99.9 % | "
            "fate errors | steps: mean | most | core-s | x floor | x default |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    else
        fmt::print(
            "| method | bytes | build ms | core-s | x floor | screen error px: max | 99.9 % | median | on a disc: max "
            "| forward error rad: max | median | fate errors |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::fflush(stdout);
}

void print_row(const Row& row, bool spins, const Row& own) {
    if (spins)
        fmt::print(
            "| {} | {:.2g} | {:.2g} | {:.2g} | {} | {:.2g} | {:.2g} | {} | {:.2f} | {} | {:.4f} | {:.2f} | {:.2f} |\n",
            row.name, row.screen_px.max, row.screen_px.p999, row.screen_px.median, row.fate_errors, row.near_px.max,
            row.near_px.p999, row.near_fate_errors, row.mean_steps(), row.most_steps, row.core_s(), row.floor_ratio(),
            row.core_s() / own.core_s());
    else
        fmt::print(
            "| {} | {} | {:.1f} | {:.4f} | {:.2f} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {} |\n",
            row.name, row.bytes, row.build_ms, row.core_s(), row.floor_ratio(), row.screen_px.max, row.screen_px.p999,
            row.screen_px.median, row.disc_px.max, row.forward_rad.max, row.forward_rad.median, row.fate_errors);
    std::fflush(stdout);
}

// What every method for rotating holes draws: the sky, and no time to pass.
Scene sky_alone(const Scene& scene) {
    Scene alone;
    alone.name = scene.name, alone.spacetime = scene.spacetime, alone.camera = scene.camera, alone.sky = scene.sky;
    return alone;
}

// Each with its row printed.
Status measure(const Bench& bench, const std::vector<ErrorView>& views, const Scene& scene, bool spins, int frames,
               std::vector<Row>& rows) {
    Scene flat = scene;
    flat.spacetime = {"minkowski", {}};
    flat.camera.zoom.reset();
    TRY(flat_ready, bench.other->prepare(flat));
    bench.draw(*bench.other);
    Renderer tracer;  // of ray data: the others keep their skies
    Progress progress("methods", static_cast<long long>(rows.size() * (views.size() + 1)));
    print_head(spins);
    for (Row& row : rows) {
        TRY(cost, measure_cost(bench, scene, frames, row));
        progress.advance();
        TRY(errors, measure_errors(tracer, views, row, [&] { progress.advance(); }));
        progress.clear();
        print_row(row, spins, rows.front());
    }
    return Done{};
}

void print_frontier(const std::vector<Row>& rows) {
    std::string names;
    for (const Row& row : rows)
        if (row.on_frontier) names += (names.empty() ? "" : ", ") + row.name;
    fmt::print("\nOn the frontier (no other is at least as accurate at lower cost): {}\n", names);
}

void print_whole_frames(const std::vector<Row>& rows) {
    fmt::print("\n| method | of its rows | core-s | of whole frames | ratio |\n|---|---|---|---|---|\n");
    for (const Row& row : rows) {
        const double whole = median(row.whole.core_s);
        fmt::print("| {} | 1/{} | {:.4f} | {:.4f} | {:.3f} |\n", row.name, row.part, row.core_s(), whole,
                   row.core_s() / whole);
    }
}

Status plot(const Bench& bench, const std::vector<ErrorView>& views, const std::vector<Row>& rows,
            const std::string& file) {
    std::vector<PlotPoint> points;
    points.reserve(rows.size());
    for (const Row& row : rows)
        points.push_back({row.name, row.method, row.core_s(), row.screen_px.max, row.on_frontier, row.is_default()});
    const Scene& first = views.front().scene;
    const std::string subtitle = fmt::format(
        "{}, {}, {}, {} threads; {} cameras, every {}th pixel of a 4K frame; grey: dominated", first.spacetime.metric,
        bench.session.context->kind(), bench.driver(), std::thread::hardware_concurrency(),
        std::ranges::count_if(views, [](const ErrorView& v) { return !v.scene.disc && !v.near; }),
        k4kWidth / first.camera.width);
    return write_text_atomically(file, accuracy_svg(points, median(rows.front().floor.core_s), subtitle));
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
            return bad_input(fmt::format("scene {}: light travels straight in {}, there is nothing to compare", name,
                                         scene->spacetime.metric));
        TRY(spacetime, make_spacetime(scene->spacetime.metric, scene->spacetime.parameters));
        TRY(rows, accuracy_rows(**spacetime));
        const std::vector<ErrorView> views = error_views(scene->spacetime, **spacetime);
        Scene drawn = spins ? sky_alone(*scene) : *scene;
        drawn.picture.refine = false;  // a ray a pixel, whatever the picture shows
        drawn.camera.width = kTimeWidth, drawn.camera.height = kTimeHeight;
        TRY(done, measure(*bench, views, drawn, spins, options.frames, *rows));
        std::vector<MeasuredMethod> all;
        all.reserve(rows->size());
        for (const Row& row : *rows)
            all.push_back({scene->spacetime.metric, row.method, row.screen_px.max, row.floor_ratio(), row.disc_px.max});
        if (!spins) measured.insert(measured.end(), all.begin(), all.end());
        for (std::size_t i = 0; i < rows->size(); ++i) (*rows)[i].on_frontier = !is_dominated(all[i], all);
        print_frontier(*rows);
        if (options.whole_frames) {
            TRY(whole, measure_whole_frames(*bench, drawn, options.frames, *rows));
            print_whole_frames(*rows);
        }
        for (const Row& row : *rows) objects.push_back(json_of(row, *bench, scene->spacetime.metric));
        if (!options.plot.empty()) {
            TRY(plotted, plot(*bench, views, *rows, options.plot));
        }
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
                             "sizes and orders, as a table, a diagram and JSON",
                             run);
    command.add_option("scenes", &options.scenes, "Scenes whose spacetime and sky are used").show_default();
    context_option(command, options.context);
    number_option(command, "--frames", options.frames, 3, 1000, "Timed frames of each method");
    command.add_flag(
        "--whole-frames", &options.whole_frames,
        "At the end measure costs once more, all methods in turn and whole frames of the slow ones; minutes");
    json_option(command, options);
    command.add_option("--plot", &options.plot, "Write the work-precision diagram to this SVG file");
    command.add_option(
        "--frontier", &options.frontier,
        "Write the methods that --method auto chooses from to this CSV file (built in: assets/frontier.csv)");
}

}  // namespace nullscope::cli
