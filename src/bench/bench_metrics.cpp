// nullscope bench metrics: one scene in every spacetime. What a frame costs against the same frame about a Schwarzschild hole, drawn in
// turn (A B A B ...), and what it takes to build a metric's tables anew.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/progress.h"
#include "bench/bench.h"
#include "command/arguments.h"
#include "command/json.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

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

// Deflection table, strip and what the scene's objects need, from nothing.
Result<Samples> time_tables(const Scene& scene) {
    Samples samples;
    for (int i = 0; i < kTableRuns; ++i) {
        Status built = Done{};
        time_one(samples, [&] { built = FrameTables().update(scene); });
        if (!built) return built.error();
    }
    return samples;
}

Result<Json> measure_metric(const Bench& bench, Scene scene, const SpacetimeSpec& spec, int frames) {
    TRY(spacetime, make_spacetime(spec.metric, spec.parameters));
    if (!(*spacetime)->can_have_disc()) scene.disc.reset();  // of both frames
    Scene other = scene;
    scene.spacetime = spec;
    other.spacetime = {"schwarzschild", {}};
    TRY(ready, bench.prepare(scene, other));
    const auto samples = bench.time_in_turn(frames);
    TRY(tables, time_tables(scene));
    const double core = median(samples[0].core_s), core_of_hole = median(samples[1].core_s),
                 tables_ms = median(tables->wall_ms), tables_core_ms = 1e3 * median(tables->core_s);
    fmt::print("{:<12} {:<30} {:.4f} core-s, Schwarzschild {:.4f}: ratio {:.3f}; tables {:.1f} ms, {:.1f} core-ms{}\n",
               scene.name, label_of(spec), core, core_of_hole, core / core_of_hole, tables_ms, tables_core_ms,
               scene.disc ? ", with the disc" : "");
    return Json{
        {"scene", scene.name},          {"spacetime", label_of(spec)},   {"renderer", bench.driver()},
        {"width", bench.target.width},  {"height", bench.target.height}, {"frames", frames},
        {"disc", scene.disc ? 1 : 0},   {"core_seconds", core},          {"schwarzschild_core_seconds", core_of_hole},
        {"ratio", core / core_of_hole}, {"tables_ms", tables_ms},        {"tables_core_ms", tables_core_ms}};
}

Status run_metrics(const BenchOptions& options) {
    TRY(bench, open_bench(options));
    Json rows = Json::array();
    const std::vector<SpacetimeSpec> list = spacetimes();
    Progress progress("metrics", static_cast<long long>(options.scenes.size() * list.size()));
    for (const std::string& name : options.scenes) {
        TRY(scene, load_scene_sized(name, options.size));
        for (const SpacetimeSpec& spec : list) {
            TRY(row, measure_metric(*bench, *scene, spec, options.frames));
            rows.push_back(std::move(*row));
            progress.advance();
        }
    }
    return write_json(options.json, rows);
}

}  // namespace

void add_bench_metrics(Command& bench) {
    auto [command, options] = add_command<BenchOptions>(
        bench, "metrics",
        "One scene in every spacetime: frame time relative to Schwarzschild, and the time to build its tables",
        run_metrics);
    options.scenes = {"sky-only", "first-light"};
    command.add_option("scenes", &options.scenes, "Scenes whose camera, sky and disc are used").show_default();
    draw_options(command, options, 9);
    json_option(command, options);
}

}  // namespace nullscope::cli
