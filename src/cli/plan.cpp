// nullscope plan: the chain from a scene to its picture, with what in the scene calls for each link. Needs no OpenGL but to measure.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "base/assets.h"
#include "base/large_image.h"
#include "cli/bench_effects.h"
#include "cli/command.h"
#include "cli/json.h"
#include "render/renderer.h"
#include "scene/moving.h"
#include "scene/scene_file.h"
#include "shaderlib/passes.h"
#include "sky/point_stars.h"
#include "table/disc_light.h"

namespace nullscope::cli {
namespace {

constexpr int kMostCubeFace = 16384;  // px; what drivers allow is said by `nullscope info`

struct Options {
    std::string scene;
    bool json = false, measure = false;
    int frames = 9;
};

// A table or texture: layers of width x height.
struct Line {
    std::string name;
    long long layers, width, height, bytes;
    std::string place, reason;  // where it lives; what calls for it
};

struct Plan {
    Scene scene;
    std::vector<EffectReason> effects;
    std::vector<Line> tables;
    long long shader_bytes = 0, shader_lines = 0;
    std::vector<EffectCost> costs;  // where they were measured
};

long long bytes_of(std::size_t bytes) { return static_cast<long long>(bytes); }

// What calls for a table of the light's path, by its name.
std::string reason_of(std::string_view name, const Scene& scene) {
    if (name == "delay map") return fmt::format("{}", fmt::join(moving_parts(scene), ", "));
    if (name != "orbit map") return fmt::format("camera.r = {}", scene.camera.r);
    std::vector<std::string> objects;
    if (scene.disc) objects.emplace_back("[disc]");
    if (scene.sphere) objects.emplace_back("[sphere]");
    if (scene.cylinder) objects.emplace_back("[cylinder]");
    if (scene.ball) objects.emplace_back("[ball]");
    if (scene.surface) objects.emplace_back("[surface]");
    return fmt::format("{}", fmt::join(objects, ", "));
}

void add_tables(const FrameTables& tables, const Scene& scene, std::vector<Line>& lines) {
    if (const DeflectionTable* table = tables.path().table())
        lines.push_back({"deflection table", 3, table->size() + 1, table->size() + 1, bytes_of(table->bytes()), "host",
                         fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    for (const auto& [name, texels] : tables.path().tables())
        lines.push_back({std::string(name), 1, texels->width, texels->height, bytes_of(texels->bytes()),
                         name == "ray ends" && !meets_objects(tables.effects()) ? "host" : "GPU",
                         reason_of(name, scene)});
    if (const BallPath* path = tables.ball_path())
        lines.push_back(
            {"ball's way", 1, path->row.width, path->row.height, bytes_of(path->row.bytes()), "GPU", "ball.motion"});
}

// As Renderer::textures() counts them, once made.
Status add_pictures(const EffectSet& effects, const Scene& scene, std::vector<Line>& lines) {
    if (effects.contains(Effect::kSky)) {
        const long long size = sky_face_size(scene.camera, kMostCubeFace);
        lines.push_back({"sky", 6, size, size, 32 * size * size, "GPU",
                         "camera.fov and camera.size: a texel a pixel"});  // 4 B, mip levels
    }
    if (effects.contains(Effect::kThermalDisc)) {
        lines.push_back({"disc flow", 1, kDiscFlowCells + 1, 1, 16 * (kDiscFlowCells + 1), "GPU", "disc.emission"});
    }
    if (shades_heat(effects) || effects.contains(Effect::kPointStars))
        lines.push_back({"black body", 1, kBlackBodyCells + 1, 1, 16 * (kBlackBodyCells + 1), "GPU",
                         "disc.emission, sky.kind, sky.temperature"});
    if (effects.contains(Effect::kPointStars)) {
        const auto stars = point_stars(scene.sky, assets_directory());
        if (!stars) return stars.error();
        const long long count = static_cast<long long>(stars->size());
        lines.push_back({"stars", 1, count, 1, 20 * count, "GPU", "sky.kind, sky.faintest"});
    }
    if (keeps_light(passes(effects, Output::kDisplay))) {
        const long long w = scene.camera.width, h = scene.camera.height;
        lines.push_back({"linear picture", 1, w, h, 8 * w * h, "GPU", "camera.size"});  // 8 B
        if (effects.contains(Effect::kBloom) ||
            effects.contains(Effect::kAutoExposure))  // halves of halves, down and up
            lines.push_back(
                {"bloom", 2, (w + 1) / 2, (h + 1) / 2, 16 * w * h / 3, "GPU", "picture.bloom, picture.auto_exposure"});
    }
    if (effects.contains(Effect::kDiscImage)) {
        const auto image = load_disc_image(*scene.disc);
        if (!image) return image.error();
        const long long w = image->image.width, h = image->image.height;
        lines.push_back({"disc image", 1, w, h, w * h * 32 / 3, "GPU", "disc.image"});  // 8 B, mip levels
    }
    constexpr const char* kBodies[kBodyCount] = {"sphere", "cylinder", "ball", "surface"};
    for (int body = 0; body < kBodyCount; ++body) {
        const auto file = body_image_file(scene, body);
        if (!file) continue;
        const auto image = load_fitted_image(*file);
        if (!image) return image.error();
        const long long w = image->image.width, h = image->image.height;
        lines.push_back({fmt::format("{} image", kBodies[body]), 1, w, h, w * h * 32 / 3, "GPU",
                         fmt::format("{}.image", kBodies[body])});
    }
    return Done{};
}

Result<Plan> make_plan(const Scene& scene) {
    FrameTables tables;
    if (Status made = tables.update(scene); !made) return made.error();
    Plan plan{scene, tables.plan().reasons, {}, 0, 0, {}};
    add_tables(tables, scene, plan.tables);
    if (Status added = add_pictures(tables.effects(), scene, plan.tables); !added) return added.error();
    std::string shader;
    for (const Pass& pass : passes(tables.effects(), Output::kDisplay))
        shader += pass_text(pass, tables.effects(), {}, scene.spacetime.metric, body_text(scene, tables.effects()));
    plan.shader_bytes = bytes_of(shader.size());
    plan.shader_lines = std::count(shader.begin(), shader.end(), '\n');
    return plan;
}

std::vector<const EffectRow*> left_out(const Plan& plan) {
    const EffectSet effects = effect_set(plan.effects);
    std::vector<const EffectRow*> rows;
    for (const EffectRow* row : effect_rows())
        if (!effects.contains(row->effect)) rows.push_back(row);
    return rows;
}

const EffectCost* cost_of(const Plan& plan, Effect effect) {
    for (const EffectCost& cost : plan.costs)
        if (cost.effect == effect) return &cost;
    return nullptr;
}

std::string size_text(long long bytes) {
    return bytes < 1 << 20 ? fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024.0)
                           : fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1048576.0);
}

void print_text(const Plan& plan) {
    const CameraSpec& camera = plan.scene.camera;
    fmt::print("{}\n\nEffects\n", plan.scene.name);
    for (const EffectReason& effect : plan.effects) {
        fmt::print("  {:<18}{}\n  {:<18}costs: {}\n", effect_row(effect.effect).key, effect.reason, "",
                   effect_row(effect.effect).cost);
        if (const EffectCost* cost = cost_of(plan, effect.effect))
            fmt::print("  {:<18}measured: {:+.4f} of {:.4f} core-s ({:+.0f} %), {:+.2f} x the empty scene's {:.4f}\n",
                       "", cost->with_s - cost->without_s, cost->with_s,
                       100.0 * (cost->with_s - cost->without_s) / cost->with_s, cost->over_floor(), cost->floor_s);
        else if (!plan.costs.empty())
            fmt::print("  {:<18}measured: not, it cannot go alone\n", "");
    }
    if (plan.effects.empty()) fmt::print("  none\n");
    fmt::print("Left out: not compiled, not built, not run\n");
    for (const EffectRow* row : left_out(plan)) fmt::print("  {:<18}needs: {}\n", row->key, row->needs);
    fmt::print("Tables and textures\n");
    for (const Line& t : plan.tables)
        fmt::print("  {:<18}{:>1} x {:>5} x {:<5} {:>10}  {:<4}  {}\n", t.name, t.layers, t.width, t.height,
                   size_text(t.bytes), t.place, t.reason);
    if (plan.tables.empty()) fmt::print("  none\n");
    fmt::print("Passes\n");
    for (const Pass& pass : passes(effect_set(plan.effects), Output::kDisplay))
        fmt::print("  {:<18}{} x {} px; {}\n", pass.name, camera.width, camera.height, pass.what);
    fmt::print("Shaders\n  {} bytes, {} lines (nullscope capture SCENE --dump-shader prints it)\n", plan.shader_bytes,
               plan.shader_lines);
}

std::string json_of(const Plan& plan) {
    std::vector<JsonObject> effects, off, tables;
    for (const EffectReason& e : plan.effects) {
        const EffectRow& row = effect_row(e.effect);
        effects.push_back(JsonObject()
                              .add("effect", row.key)
                              .add("reason", e.reason)
                              .add("define", row.define)
                              .add("cost", row.cost));
        if (const EffectCost* cost = cost_of(plan, e.effect))
            effects.back()
                .add("core_seconds", cost->with_s)
                .add("without_core_seconds", cost->without_s)
                .add("empty_core_seconds", cost->floor_s);
    }
    for (const EffectRow* row : left_out(plan))
        off.push_back(JsonObject().add("effect", row->key).add("needs", row->needs));
    long long total = 0;
    for (const Line& t : plan.tables) {
        tables.push_back(JsonObject()
                             .add("name", t.name)
                             .add("layers", t.layers)
                             .add("width", t.width)
                             .add("height", t.height)
                             .add("bytes", t.bytes)
                             .add("place", t.place)
                             .add("reason", t.reason));
        total += t.bytes;
    }
    std::vector<JsonObject> drawn;
    for (const Pass& pass : passes(effect_set(plan.effects), Output::kDisplay))
        drawn.push_back(JsonObject()
                            .add("name", pass.name)
                            .add("width", plan.scene.camera.width)
                            .add("height", plan.scene.camera.height)
                            .add("what", pass.what));
    const auto shader = JsonObject().add("bytes", plan.shader_bytes).add("lines", plan.shader_lines);
    JsonObject all;
    all.add("scene", plan.scene.name).add("metric", plan.scene.spacetime.metric);
    all.raw("effects", json_array(effects)).raw("left_out", json_array(off)).raw("tables", json_array(tables));
    all.add("table_bytes", total).raw("passes", json_array(drawn)).raw("shader", shader.text());
    return all.text() + "\n";
}

int run(const Options& options) {
    const auto scene = load_scene(options.scene);
    if (!scene) return report(scene.error());
    auto plan = make_plan(*scene);
    if (!plan) return report(plan.error());
    if (options.measure) {
        auto costs = effect_costs(*scene, "auto", options.frames);
        if (!costs) return report(costs.error());
        plan->costs = std::move(*costs);
    }
    if (options.json)
        fmt::print("{}", json_of(*plan));
    else
        print_text(*plan);
    return 0;
}

}  // namespace

void add_plan(Command& parent) {
    auto options = std::make_shared<Options>();
    Command& command =
        parent.add_command("plan", "Say what a scene calls for: effects, tables, textures, passes, shader; and why");
    command.add_option("scene", &options->scene, "Scene file, or the name of one that ships (see: nullscope scenes)")
        .required();
    command.add_flag("--json", &options->json, "Print one JSON object");
    command.add_flag("--measure", &options->measure,
                     "Draw the scene with and without each effect, and say what it takes");
    command.add_option("--frames", &options->frames, "Frames of each kind")
        .in_range(3, 1000)
        .show_default()
        .needs("--measure");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
