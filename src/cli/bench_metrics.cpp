// nullscope bench metrics: one scene in every spacetime. What a frame costs against the same frame about a Schwarzschild hole, drawn in
// turn (A B A B ...), and what it takes to build a metric's tables anew.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/arguments.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/session.h"
#include "scene/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::vector<std::string> scenes = {"sky-only", "first-light"};
    std::string size = "1280x720", context = "auto", json;
    int frames = 21;
};

constexpr int kTableRuns = 9;

// Every metric of the registry as it is by itself, and the charges that are another kind of spacetime.
std::vector<SpacetimeSpec> spacetimes() {
    std::vector<SpacetimeSpec> list;
    for (const MetricEntry& entry : metric_registry()) {
        list.push_back({std::string(entry.key), {}});
        if (entry.key == "reissner-nordstrom")
            for (const double charge : {1.0, 1.2}) list.push_back({std::string(entry.key), {{"charge", charge}}});
    }
    return list;
}

std::string label_of(const SpacetimeSpec& spec) {
    std::string label = spec.metric;
    for (const auto& [name, value] : spec.parameters) label += fmt::format(" {} {}", name, value);
    return label;
}

struct TableTime {
    double wall_ms, core_ms;
};

// Deflection table, strip and what the scene's objects need, from nothing.
Result<TableTime> time_tables(const Scene& scene) {
    Samples samples;
    for (int i = 0; i < kTableRuns; ++i) {
        Status built = Done{};
        time_one(samples, [&] { built = FrameTables().update(scene); });
        if (!built) return built.error();
    }
    return TableTime{median(samples.wall_ms), 1e3 * median(samples.core_s)};
}

Result<JsonObject> measure(Session& session, Renderer& twin, const gl::Target& target, Scene scene,
                           const SpacetimeSpec& spec, int frames) {
    const auto spacetime = make_spacetime(spec.metric, spec.parameters);
    if (!spacetime) return spacetime.error();
    if (!(*spacetime)->can_have_disc()) scene.disc.reset();  // of both frames
    Scene other = scene;
    scene.spacetime = spec;
    other.spacetime = {"schwarzschild", {}};
    if (Status ready = session.renderer->prepare(scene); !ready) return ready.error();
    if (Status ready = twin.prepare(other); !ready) return ready.error();
    const auto draw = [&](Renderer& renderer) {
        renderer.draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay);
    };
    for (Renderer* renderer : {session.renderer.get(), &twin}) draw(*renderer);  // compiles
    Samples picture, hole;
    for (int i = 0; i < frames; ++i) {
        time_one(picture, [&] { draw(*session.renderer); });
        time_one(hole, [&] { draw(twin); });
    }
    const auto tables = time_tables(scene);
    if (!tables) return tables.error();
    const double core = median(picture.core_s), core_of_hole = median(hole.core_s);
    fmt::print("{:<12} {:<30} {:.4f} core-s, Schwarzschild {:.4f}: ratio {:.3f}; tables {:.1f} ms, {:.1f} core-ms{}\n",
               scene.name, label_of(spec), core, core_of_hole, core / core_of_hole, tables->wall_ms, tables->core_ms,
               scene.disc ? ", with the disc" : "");
    JsonObject row;
    row.add("scene", scene.name).add("spacetime", label_of(spec)).add("renderer", session.renderer->info().renderer);
    row.add("width", target.width).add("height", target.height).add("frames", frames).add("disc", scene.disc ? 1 : 0);
    row.add("core_seconds", core).add("schwarzschild_core_seconds", core_of_hole).add("ratio", core / core_of_hole);
    row.add("tables_ms", tables->wall_ms).add("tables_core_ms", tables->core_ms);
    return row;
}

int run(const Options& options) {
    const auto size = parse_size(options.size);
    if (!size) return report(size.error());
    auto session = open_session(options.context);
    if (!session) return report(session.error());
    auto twin = std::make_unique<Renderer>();
    const gl::Target target = gl::make_target(size->width, size->height, gl::Format::kRgba8);
    std::vector<JsonObject> rows;
    const std::vector<SpacetimeSpec> list = spacetimes();
    Progress progress("metrics", static_cast<long long>(options.scenes.size() * list.size()));
    for (const std::string& name : options.scenes) {
        auto scene = load_scene(name);
        if (!scene) return report(scene.error());
        scene->camera.width = size->width;
        scene->camera.height = size->height;
        for (const SpacetimeSpec& spec : list) {
            auto row = measure(*session, *twin, target, *scene, spec, options.frames);
            if (!row) return report(row.error());
            rows.push_back(std::move(*row));
            progress.advance();
        }
    }
    if (options.json.empty()) return 0;
    if (Status written = write_text_atomically(options.json, json_list(rows)); !written) return report(written.error());
    return 0;
}

}  // namespace

void add_bench_metrics(Command& bench) {
    auto options = std::make_shared<Options>();
    Command& command = bench.add_command(
        "metrics", "One scene in every spacetime: a frame's time over Schwarzschild's, and the time of its tables");
    command.add_option("scenes", &options->scenes, "Scenes whose camera, sky and disc are used").show_default();
    command.add_option("--size", &options->size, "Frame size, WIDTHxHEIGHT").show_default();
    context_option(command, options->context);
    command.add_option("--frames", &options->frames, "Frames of each kind").in_range(9, 10000).show_default();
    command.add_option("--json", &options->json, "Write the rows to this file");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
