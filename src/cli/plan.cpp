// nullscope plan: the chain from a scene to its picture, with what in the scene calls for each link. Needs no OpenGL but to measure.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/assets.h"
#include "bench/bench.h"
#include "cli/command.h"
#include "command/json.h"
#include "image/large_image.h"
#include "plan/moving.h"
#include "render/body_images.h"
#include "render/renderer.h"
#include "render/warp_texture.h"
#include "scene/bodies.h"
#include "scenefile/scene_file.h"
#include "shaderlib/passes.h"
#include "sky/packed_sky.h"
#include "sky/point_stars.h"
#include "table/disc_light.h"

namespace nullscope::cli {
namespace {

constexpr int kMostCubeFace = 16384;  // px; what drivers allow is said by `nullscope info`

struct PlanOptions {
    std::string scene;
    bool json = false, measure = false;
    int frames = 9;
};

// A table or texture: layers of width x height.
struct PlanLine {
    std::string name;
    long long layers, width, height, bytes;
    std::string place, reason;  // where it lives; what calls for it
};

struct Plan {
    Scene scene;
    std::vector<EffectReason> effects;
    std::vector<PlanLine> tables;
    long long shader_bytes = 0, shader_lines = 0;
    std::vector<EffectCost> costs;  // where they were measured
};

// What calls for a table of the light's path, by its name.
std::string reason_of(std::string_view name, const Scene& scene) {
    if (name == "light-time table") return moving_words(scene);
    if (name != "orbit table") return fmt::format("camera.r = {}", scene.camera.r);
    std::vector<std::string> objects;
    if (scene.disc) objects.emplace_back("[disc]");
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        objects.push_back(fmt::format("[{}]", body_section(scene, i)));
    return fmt::format("{}", fmt::join(objects, ", "));
}

void add_tables(const FrameTables& tables, const Scene& scene, std::vector<PlanLine>& lines) {
    if (const DeflectionTable* table = tables.path().table())
        lines.push_back({"deflection table", 3, table->size() + 1, table->size() + 1,
                         static_cast<long long>(table->bytes()), "host",
                         fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    for (const auto& [name, texels] : tables.path().tables())
        lines.push_back({std::string(name), 1, texels->width, texels->height, static_cast<long long>(texels->bytes()),
                         name == "ray ends" && !meets_objects(tables.effects()) ? "host" : "GPU",
                         reason_of(name, scene)});
    if (const BallPaths& paths = tables.ball_paths(); !paths.balls.empty())
        lines.push_back({"ball paths", static_cast<long long>(paths.balls.size()), paths.rows.width, 2,
                         static_cast<long long>(paths.rows.bytes()), "GPU", "ball.motion"});
    if (const SurfaceClearances& clearances = tables.clearances(); clearances.rows() > 0)
        lines.push_back({"surface clearance", 1, kClearanceWidth, clearances.rows(),
                         4LL * kClearanceWidth * clearances.rows(), "GPU", "surface.shape and surface.bound"});
}

// As Renderer::textures() counts them, once made.
Status add_pictures(const EffectSet& effects, const Scene& scene, std::vector<PlanLine>& lines) {
    const bool far = effects.contains(Effect::kFarSky), near = effects.contains(Effect::kSky);
    if (far || near) {
        const SkyFaces faces = sky_faces(sky_asked(scene, effects), kMostCubeFace);
        const long long size = far && near ? bordered_size(faces.size) : faces.size;
        for (const auto& [name, there] : {std::pair{"far sky", far}, {"sky", near}})
            if (there)  // with mip levels
                lines.push_back({name, 6, size, size, (faces.halves ? 64 : 32) * size * size, "GPU",
                                 fmt::format("{}; {}", faces.words(), faces.halves ? "half floats" : "small floats")});
    }
    if (effects.contains(Effect::kThermalDisc))
        lines.push_back({"disc flow", 1, kDiscFlowCells + 1, kDiscFlowRows, 16 * (kDiscFlowCells + 1) * kDiscFlowRows,
                         "GPU", "disc.emission"});
    if (shades_heat(effects) || effects.contains(Effect::kPointStars))
        lines.push_back({"black body", 1, kBlackBodyCells + 1, 1, 16 * (kBlackBodyCells + 1), "GPU",
                         "disc.emission, sky.kind, sky.temperature"});
    if (effects.contains(Effect::kPointStars)) {
        TRY(stars, point_stars(scene.sky, assets_directory()));
        const long long count = static_cast<long long>(stars->size());
        lines.push_back({"stars", 1, count, 1, 20 * count, "GPU", "sky.kind, sky.magnitude_limit"});
    }
    if (effects.contains(Effect::kWarp)) {
        TRY(mesh, load_warp_mesh(scene.camera.warp));
        const auto bytes = static_cast<long long>(sizeof(float) * warp_texels(**mesh, input_half(scene.camera)).size());
        lines.push_back({"warp mesh", 1, kWarpRow, bytes / (16 * kWarpRow), bytes, "GPU", "camera.warp"});
    }
    if (keeps_light(passes(effects, Output::kDisplay))) {
        const long long w = scene.camera.width, h = scene.camera.height;
        lines.push_back({"linear picture", 1, w, h, 8 * w * h, "GPU", "camera.size"});  // 8 B
        if (effects.contains(Effect::kBloom) ||
            effects.contains(Effect::kAutoExposure))  // halves of halves, down and up
            lines.push_back(
                {"bloom", 2, (w + 1) / 2, (h + 1) / 2, 16 * w * h / 3, "GPU", "picture.bloom, picture.auto_exposure"});
    }
    const auto add_image = [&](const std::string& section, const Image<float>& image) {
        const long long w = image.width, h = image.height;
        lines.push_back({section + " image", 1, w, h, w * h * 32 / 3, "GPU", section + ".image"});  // 8 B, mip levels
    };
    if (effects.contains(Effect::kDiscImage)) {
        TRY(image, load_disc_image(*scene.disc));
        add_image("disc", image->image);
    }
    for (const auto& file : body_images(scene)) {
        TRY(image, load_fitted_image(file, body_image_limits(ImageLimits().max_side)));
        std::size_t body = 0;
        while (scene.bodies[body].material.image != file) ++body;
        add_image(body_section(scene, body), image->image);
    }
    return Done{};
}

Result<Plan> make_plan(const Scene& scene) {
    FrameTables tables;
    TRY(made, tables.update(scene));
    Plan plan{scene, tables.plan().reasons, {}, 0, 0, {}};
    add_tables(tables, scene, plan.tables);
    TRY(added, add_pictures(tables.effects(), scene, plan.tables));
    std::string shader;
    for (const Pass& pass : passes(tables.effects(), Output::kDisplay))
        shader += pass_text(pass, tables.effects(), {}, scene.spacetime.metric, body_text(scene, tables.effects()));
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

std::string size_text(long long bytes) {
    return bytes < 1 << 20 ? fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024.0)
                           : fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1048576.0);
}

void print_text(const Plan& plan) {
    const CameraSpec& camera = plan.scene.camera;
    fmt::print("{}\n\nEffects\n", plan.scene.name);
    for (const EffectReason& effect : plan.effects) {
        fmt::print("  {:<19}{}\n  {:<19}costs: {}\n", effect_row(effect.effect).key, effect.reason, "",
                   effect_row(effect.effect).cost);
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
    for (const PlanLine& t : plan.tables)
        fmt::print("  {:<19}{:>1} x {:>5} x {:<5} {:>10}  {:<4}  {}\n", t.name, t.layers, t.width, t.height,
                   size_text(t.bytes), t.place, t.reason);
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
    fmt::print("Shaders\n  {} bytes, {} lines (nullscope capture SCENE --dump-shader prints it)\n", plan.shader_bytes,
               plan.shader_lines);
}

Json json_of(const Plan& plan) {
    Json effects = Json::array(), off = effects, tables = effects, drawn = effects;
    for (const EffectReason& e : plan.effects) {
        const EffectRow& row = effect_row(e.effect);
        Json o{{"effect", row.key}, {"reason", e.reason}, {"define", row.define}, {"cost", row.cost}};
        if (const EffectCost* cost = cost_of(plan, e.effect)) {
            o["core_seconds"] = cost->with_s, o["without_core_seconds"] = cost->without_s;
            o["empty_core_seconds"] = cost->floor_s;
            if (e.effect == Effect::kRefine) o["refined_share"] = cost->refined;
        }
        effects.push_back(std::move(o));
    }
    for (const EffectRow* row : left_out(plan)) off.push_back({{"effect", row->key}, {"needs", row->needs}});
    long long total = 0;
    for (const PlanLine& t : plan.tables) {
        tables.push_back({{"name", t.name},
                          {"layers", t.layers},
                          {"width", t.width},
                          {"height", t.height},
                          {"bytes", t.bytes},
                          {"place", t.place},
                          {"reason", t.reason}});
        total += t.bytes;
    }
    const CameraSpec& camera = plan.scene.camera;
    for (const Pass& pass : passes(effect_set(plan.effects), Output::kDisplay))
        drawn.push_back({{"name", pass.name}, {"width", camera.width}, {"height", camera.height}, {"what", pass.what}});
    return Json{{"scene", plan.scene.name}, {"metric", plan.scene.spacetime.metric},
                {"effects", effects},       {"left_out", off},
                {"tables", tables},         {"table_bytes", total},
                {"passes", drawn},          {"shader", {{"bytes", plan.shader_bytes}, {"lines", plan.shader_lines}}}};
}

Result<int> run_plan(const PlanOptions& options) {
    TRY(scene, load_scene(options.scene));
    TRY(plan, make_plan(*scene));
    if (options.measure) {
        TRY(costs, effect_costs(*scene, "auto", options.frames));
        plan->costs = std::move(*costs);
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
    command.add_flag("--json", &options.json, "Print one JSON object");
    command.add_flag("--measure", &options.measure,
                     "Draw the scene with and without each effect, and show what the effect costs");
    number_option(command, "--frames", options.frames, 3, 1000, "Frames of each kind").needs("--measure");
}

}  // namespace nullscope::cli
