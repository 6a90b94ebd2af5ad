// nullscope plan: the chain from a scene to its picture, with what in the scene calls for each link. Needs no OpenGL but to measure.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "cli/command.h"
#include "command/json.h"
#include "command/session.h"
#include "command/stage_choice.h"
#include "render/frame_textures.h"
#include "scenefile/scene_file.h"
#include "shaderlib/passes.h"

namespace nullscope::cli {
namespace {

struct PlanOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene;
    bool json = false, measure = false;
    ContextChoice context;
    int frames = 9;
};

struct Plan {
    Scene scene;
    std::vector<EffectReason> effects;
    std::vector<FrameTexture> tables;
    long long shader_bytes = 0, shader_lines = 0,
              compute_bytes = 0;  // compute_bytes: with compute shaders where passes can have them
    StageChoice stage{.reason = "unless --stage asks otherwise; --measure compares"};
    std::vector<std::string> remembered;  // what was measured of such a scene, a line for each device
    std::vector<EffectCost> costs;        // where they were measured
};

Result<Plan> make_plan(const Scene& scene) {
    FrameTables tables;
    TRY(made, tables.update(scene));
    TRY(textures, frame_textures(tables));
    Plan plan{.scene = scene,
              .effects = tables.plan().reasons,
              .tables = std::move(*textures),
              .remembered = remembered_stages(scene, tables.effects()),
              .costs = {}};
    std::string shader;
    const BodyText bodies = body_text(scene, tables.effects());
    for (const Pass& pass : passes(tables.effects(), Output::kDisplay)) {
        const std::string text = pass_text(pass, tables.effects(), {}, scene.spacetime.metric, bodies);
        const std::string computed = computes(pass.stage) ? compute_source(pass.stage, tables.effects(), pass.output,
                                                                           {}, scene.spacetime.metric, bodies)
                                                          : text;
        shader += text;
        plan.compute_bytes += static_cast<long long>(computed.size());
    }
    plan.shader_bytes = static_cast<long long>(shader.size());
    plan.shader_lines = std::ranges::count(shader, '\n');
    return plan;
}

std::vector<const EffectRow*> left_out(const Plan& plan) {
    const EffectSet effects = effect_set(plan.effects);
    std::vector<const EffectRow*> rows = effect_rows();
    std::erase_if(rows, [&](const EffectRow* row) { return effects.contains(row->effect); });
    return rows;
}

const EffectCost* cost_of(const Plan& plan, Effect effect) {
    for (const EffectCost& cost : plan.costs)
        if (cost.effect == effect) return &cost;
    return nullptr;
}

// The tables and textures that an effect needs, and its work.
std::string cost_words(const Plan& plan, Effect effect) {
    std::vector<std::string> needed;
    for (const FrameTexture& texture : plan.tables)
        if (std::ranges::find(texture.effects, effect) != texture.effects.end()) needed.push_back(texture.name);
    const std::string_view work = effect_row(effect).cost;
    return needed.empty() ? std::string(work) : fmt::format("{}; {}", fmt::join(needed, ", "), work);
}

const char* place_of(const FrameTexture& texture) { return texture.on_gpu ? "GPU" : "host"; }

std::string size_text(long long bytes) {
    return bytes < 1 << 20 ? fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024.0)
                           : fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1048576.0);
}

void print_text(const Plan& plan) {
    const CameraSpec& camera = plan.scene.camera;
    fmt::print("{}\n\nEffects\n", plan.scene.name);
    for (const EffectReason& effect : plan.effects) {
        fmt::print("  {:<19}{}\n  {:<19}costs: {}\n", effect_row(effect.effect).key, effect.reason, "",
                   cost_words(plan, effect.effect));
        if (const EffectCost* cost = cost_of(plan, effect.effect))
            fmt::print("  {:<19}measured: {:+.4f} of {:.4f} core-s ({:+.0f} %), {:+.2f} x the empty scene's {:.4f}{}\n",
                       "", cost->with_s - cost->without_s, cost->with_s,
                       100.0 * (cost->with_s - cost->without_s) / cost->with_s, cost->over_floor(), cost->floor_s,
                       effect.effect == Effect::kRefine ? fmt::format("; {:.1f} % of the pixels", 100.0 * cost->refined)
                                                        : std::string());
        else if (!plan.costs.empty())
            fmt::print("  {:<19}measured: no, it cannot be removed by itself\n", "");
    }
    if (plan.effects.empty()) fmt::print("  none\n");
    fmt::print("Left out: not compiled, not built, not run\n");
    for (const EffectRow* row : left_out(plan)) fmt::print("  {:<19}needs: {}\n", row->key, row->needs);
    fmt::print("Tables and textures\n");
    for (const FrameTexture& t : plan.tables)
        fmt::print("  {:<19}{:>1} x {:>5} x {:<5} {:>10}  {:<4}  {}\n", t.name, t.layers, t.width, t.height,
                   size_text(t.bytes), place_of(t), t.reason);
    if (plan.tables.empty()) fmt::print("  none\n");
    fmt::print("Passes\n");
    const EffectSet effects = effect_set(plan.effects);
    const std::vector<Pass> still = passes(effects, Output::kDisplay),
                            in_flight = passes(effects, Output::kDisplay, Tiles::kInterpolated);
    for (const Pass& pass : still)
        fmt::print("  {:<19}{} x {} px; {}\n", pass.name, camera.width, camera.height, pass.what);
    if (in_flight.front().stage != still.front().stage) {
        fmt::print("Passes in the viewer, once they are compiled, and in films (which interpolate nothing)\n");
        for (const Pass& pass : in_flight) fmt::print("  {:<19}{}\n", pass.name, pass.what);
    }
    fmt::print("Shaders\n  {} bytes, {} lines (nullscope capture SCENE --dump-shader prints it); by compute {} bytes\n",
               plan.shader_bytes, plan.shader_lines, plan.compute_bytes);
    fmt::print("Stage\n  {:<19}{}\n", plan.stage.stage, plan.stage.reason);
    for (const std::string& line : plan.remembered) fmt::print("  {:<19}{}\n", "measured", line);
}

Json json_of(const Plan& plan) {
    Json effects = Json::array(), off = effects, tables = effects, drawn = effects;
    for (const EffectReason& e : plan.effects) {
        const EffectRow& row = effect_row(e.effect);
        Json o{{"effect", row.key}, {"reason", e.reason}, {"define", row.define}, {"cost", cost_words(plan, e.effect)}};
        if (const EffectCost* cost = cost_of(plan, e.effect)) {
            o["core_seconds"] = cost->with_s, o["without_core_seconds"] = cost->without_s;
            o["empty_core_seconds"] = cost->floor_s;
            if (e.effect == Effect::kRefine) o["refined_share"] = cost->refined;
        }
        effects.push_back(std::move(o));
    }
    for (const EffectRow* row : left_out(plan)) off.push_back({{"effect", row->key}, {"needs", row->needs}});
    long long total = 0;
    for (const FrameTexture& t : plan.tables) {
        tables.push_back({{"name", t.name},
                          {"layers", t.layers},
                          {"width", t.width},
                          {"height", t.height},
                          {"bytes", t.bytes},
                          {"place", place_of(t)},
                          {"reason", t.reason}});
        total += t.bytes;
    }
    const CameraSpec& camera = plan.scene.camera;
    for (const Pass& pass : passes(effect_set(plan.effects), Output::kDisplay))
        drawn.push_back({{"name", pass.name}, {"width", camera.width}, {"height", camera.height}, {"what", pass.what}});
    return Json{{"scene", plan.scene.name},
                {"metric", plan.scene.spacetime.metric},
                {"effects", effects},
                {"left_out", off},
                {"tables", tables},
                {"table_bytes", total},
                {"passes", drawn},
                {"stage", {{"name", plan.stage.stage}, {"reason", plan.stage.reason}, {"measured", plan.remembered}}},
                {"shader",
                 {{"bytes", plan.shader_bytes}, {"lines", plan.shader_lines}, {"compute_bytes", plan.compute_bytes}}}};
}

Result<int> run_plan(const PlanOptions& options) {
    TRY(scene, asked_scene(options));
    TRY(plan, make_plan(*scene));
    if (!options.measure && !options.context.is_auto())
        return bad_input(fmt::format("{}: nothing is drawn", option_of(options.context)), "with --measure");
    if (options.measure) {
        TRY(costs, effect_costs(*scene, options.context, options.frames));
        plan->costs = std::move(*costs);
        TRY(session, open_session(options.context));
        TRY(ready, session->renderer->prepare(*scene));
        plan->stage = choose_stage(*session->renderer, scene->camera.width, scene->camera.height);
    }
    if (options.json)
        fmt::print("{}", json_text(json_of(*plan)));
    else
        print_text(*plan);
    return 0;
}

}  // namespace

void add_plan(Command& parent) {
    auto [command, options] = add_command<PlanOptions>(
        parent, "plan", "Show what drawing a scene needs, and why: effects, tables, textures, passes, shader",
        run_plan);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene (see: nullscope scenes)");
    set_option(command, options.set);
    command.add_flag("--json", &options.json, "Print one JSON object");
    command.add_flag("--measure", &options.measure,
                     "Draw the scene with and without each effect, and show what the effect costs");
    number_option(command, "--frames", options.frames, 3, 1000, "Frames of each kind").needs("--measure");
    context_option(command, options.context, "OpenGL context of --measure");
}

}  // namespace nullscope::cli
