#include "scenefile/scene_check.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

#include "observer/ball_motion.h"
#include "observer/eye.h"
#include "observer/observer.h"
#include "observer/picture_scale.h"
#include "observer/ring_view.h"
#include "plan/body_kind.h"
#include "plan/medium.h"
#include "plan/metric_faults.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/disc_shape.h"
#include "scene/medium_dumps.h"
#include "scene/orbit_sense.h"
#include "scene/picture_size.h"
#include "scene/projection.h"
#include "scene/warp_mesh.h"
#include "scenefile/disc_orbit_check.h"
#include "scenefile/disc_shape_check.h"
#include "scenefile/emissivity_check.h"
#include "scenefile/path_values.h"
#include "scenefile/projection_words.h"
#include "scenefile/scene_value.h"
#include "scenefile/sections.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

using Faults = std::vector<SceneFault>;
constexpr const char* kCamera = "camera";  // the section
constexpr double kWidestPlane = 1e13;      // at distance 1: fov a rounding below 180 degrees
using World = std::shared_ptr<const Spacetime>;

// nullptr: check_place() says what is wrong with it.
World world_of(const SpacetimeSpec& spec) {
    const auto made = make_spacetime(spec.metric, spec.parameters);
    return made ? *made : nullptr;
}

void append(Faults& faults, Faults more) {
    faults.insert(faults.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

Faults one(const Error& error, std::string at) { return {{error.key, error.what, error.allowed, std::move(at)}}; }

// Keys of a section that others' values rule out, or call for.
Faults check_keys(std::string_view section, const std::string& label, const Scene& holder, const GivenKeys& given) {
    Faults faults;
    for (const SceneKey& key : keys_of(section)) {
        if (key.meant == nullptr) continue;
        const std::string name = fmt::format("{}.{}", label, key.key);
        const bool meant = key.meant(holder);
        if (!meant && given(name)) faults.push_back({name, "is not used here", fmt::format("with {} only", key.with)});
        if (meant && key.needed && !given(name))
            faults.push_back({name, fmt::format("missing, but {}", key.with), allowed_text(key),
                              fmt::format("{}.{}", label, key.with.substr(0, key.with.find(' ')))});
    }
    return faults;
}

// Of all sections but the camera's, which is checked before them.
Faults check_other_keys(const Scene& scene, const GivenKeys& given) {
    Faults faults;
    for_each_section(scene, [&](const Section& section, const std::string& label, const Scene& holder) {
        if (section.name != kCamera) append(faults, check_keys(section.name, label, holder, given));
    });
    return faults;
}

bool same_picture(const CameraSpec& a, const CameraSpec& b) {
    return a.width == b.width && a.height == b.height && a.projection == b.projection &&
           a.pixel_aspect == b.pixel_aspect && a.stereo == b.stereo && a.warp == b.warp &&
           a.warp_intensity == b.warp_intensity;
}

Faults check_cube(const CameraSpec& camera) {
    const char* projection = "camera.projection";
    Faults faults;
    if (!holds_cube(camera.width, camera.height))
        faults.push_back(
            {"camera.size", fmt::format("{} x {} px do not hold a cube's faces", camera.width, camera.height),
             fmt::format("[{}], {}", cube_size_words(camera.width, camera.height, ", "), kCubeSizes), projection});
    for (const auto& [key, value, least] : {std::tuple{"camera.pixel_aspect", camera.pixel_aspect, 1.0},
                                            {"camera.shift_x", camera.shift_x, 0.0},
                                            {"camera.shift_y", camera.shift_y, 0.0}})
        if (value != least)
            faults.push_back({key, "a cube's faces are squares that meet",
                              fmt::format("{} where projection = \"cube\"", least), projection});
    return faults;
}

Faults check_lens(const Scene& scene) {
    const CameraSpec& camera = scene.camera;
    const char *fov = "camera.fov", *projection = "camera.projection";
    Faults faults;
    const ProjectionRow& row = projection_of(camera);
    if (row.flat) {
        if (camera.plane_width > 0.0 && std::isfinite(camera.plane_width) && camera.plane_width < kWidestPlane)
            return {};
        return {{fov, "too wide for a pinhole", "(0, 180), or another projection", fov}};
    }
    if (row.faces) append(faults, check_cube(camera));
    if (!faults.empty()) return faults;
    if (!row.faces && !row.field.contains(camera.plane_width)) {
        ProjectionWords range;
        range.add_range(row.field);
        return {{fov,
                 fmt::format("too {} for projection = \"{}\"", camera.plane_width < row.field.usual ? "narrow" : "wide",
                             row.name),
                 fmt::format("{}, or projection = \"pinhole\"", range.view()), fov}};
    }
    if (camera.zoom)
        return {
            {projection, "[zoom] requires projection = \"pinhole\"", "pinhole where there is a [zoom]", projection}};
    if (scene.split)
        return {
            {projection, "[split] requires projection = \"pinhole\"", "pinhole where there is a [split]", projection}};
    return {};
}

Faults check_warp(const Scene& scene) {
    const char* warp = "camera.warp";
    if (scene.camera.warp.empty()) return {};
    for (const auto& [there, what] :
         {std::pair{scene.camera.zoom.has_value(), "[zoom]"}, {scene.split.has_value(), "[split]"}})
        if (there) return {{warp, fmt::format("cannot be combined with {}", what), "one of both", warp}};
    const auto mesh = load_warp_mesh(scene.camera);
    if (mesh) return {};
    return {file_fault(warp, scene.camera.warp, mesh.error(), "a warp mesh")};
}

// In one of the scene's spacetimes.
Faults check_place(const Scene& scene, const std::string& section, const SpacetimeSpec& spec) {
    const CameraSpec& camera = scene.camera;
    const std::string metric = section + ".metric";
    for (const MetricFormula& formula : find_metric(spec.metric)->formulas)
        if (formula.needed && !spec.parameters.formulas.contains(std::string(formula.name)))
            return {{fmt::format("{}.{}", section, formula.name), fmt::format("missing, but metric is {}", spec.metric),
                     "a formula of r", metric}};
    const auto made = make_spacetime(spec.metric, spec.parameters);
    if (!made)
        return one(within(section, made.error()), metric);  // its parameters, each within its range, do not go together
    const Spacetime& spacetime = **made;
    if (camera.observer == ObserverKind::kStatic && !camera_can_rest(spacetime, camera.r))
        return {{"camera.r",
                 fmt::format("a static camera cannot be at {}{}", camera.r,
                             camera.r >= spacetime.camera_range().high ? ", on or beyond the cosmological horizon"
                             : spacetime.horizon_radius()              ? ", on or inside the horizon"
                                                                       : ""),
                 allowed_radii(spacetime), metric}};
    if (const auto observer = observer_of(spacetime, camera); !observer) return one(observer.error(), "camera.r");
    return {};
}

Faults check_stereo(const Scene& scene) {
    const CameraSpec& camera = scene.camera;
    if (camera.stereo == Stereo::kOff) return {};
    const std::string key = "camera.stereo";
    const bool all_round = camera.stereo == Stereo::kAllRound;
    if (camera.zoom) return {{key, "stereo cannot be combined with [zoom]", "off where there is a [zoom]", key}};
    if (scene.split) return {{key, "stereo cannot be combined with [split]", "off where there is a [split]", key}};
    if (!camera.warp.empty())
        return {{key, "stereo cannot be combined with camera.warp", "off where there is a camera.warp", key}};
    if (scene.picture.scale_bar != ScaleBar::kOff)
        return {{key, "a scale bar needs a single picture", "off where there is a picture.scale_bar", key}};
    if (scene.picture.auto_exposure)
        return {{key, "each eye's picture would have its own exposure", "picture.auto_exposure = \"off\"", key}};
    if (all_round && scene.picture.bloom > 0.0)
        return {{key, "all-round pictures are drawn in strips, which would cut off bloom", "picture.bloom = 0", key}};
    if (all_round && camera.projection != Projection::kEquirectangular)
        return {{key, "all-round stereo needs one direction for each column", "projection = \"equirectangular\"", key}};
    const World world = world_of(scene.spacetime);
    const Status there = world && observer_of(*world, camera) ? check_eyes(*world, camera) : Done{};
    return there ? Faults{} : one(there.error(), key);
}

Faults check_path(const Scene& scene) {
    if (!scene.path) return {};
    const PathSpec& path = *scene.path;
    Faults faults = closed_faults(path);
    const bool keys = path.kind == PathKind::kKeys;
    if (keys ? path.keys.size() < 2 : !path.keys.empty())
        faults.push_back({"path.key", keys ? "fewer than two keys, but kind is keys" : "keys, but kind is not keys",
                          keys ? "two [[path.key]] or more" : "with kind = \"keys\" only"});
    for (const PathKey& key : path.keys)
        if (key.camera.observer != path.keys.front().camera.observer || !same_picture(key.camera, scene.camera))
            faults.push_back({"path.key", "observer, projection, size, stereo or warp change along the path",
                              "one observer, projection, size, pixel_aspect, stereo and warp for all keys"});
    return faults;
}

Faults check_patterns(const Scene& scene) {
    Faults faults;
    check_checker(sky_material(scene.sky), "sky", faults);
    if (scene.disc) check_checker(scene.disc->material, "disc", faults);
    return faults;
}

Faults check_disc(const Scene& scene, const World& world, const GivenKeys& given) {
    if (!scene.disc) return {};
    Faults faults;
    const DiscSpec& disc = *scene.disc;
    for (const auto& [key, other] :
         {std::pair{"disc.mass", "disc.accretion_rate"}, {"disc.accretion_rate", "disc.mass"}}) {
        if (!given(key)) continue;
        if (!given(other))
            faults.push_back({other, fmt::format("missing, but there is a {}", key), "both or none", key});
        if (given("disc.temperature"))
            faults.push_back({"disc.temperature", fmt::format("{} gives the temperature", key), "one of both"});
    }
    if (const double most = world ? world->camera_range().high : kAnyRadius; !(disc.outer < most))
        faults.push_back({"disc.outer", fmt::format("{} is beyond the cosmological horizon", disc.outer),
                          fmt::format("below {}", most)});
    if (!(disc.inner < disc.outer))
        faults.push_back({given("disc.inner") ? "disc.inner" : "disc.outer",
                          fmt::format("inner = {} is not below outer = {}", disc.inner, disc.outer), "inner < outer"});
    if (disc.polarisation.field == DiscField::kVector && length(disc.polarisation.vector) == 0.0)
        faults.push_back({"disc.field_vector", "[0, 0, 0] has no direction", "three numbers, one of them not 0"});
    return faults;
}

Faults check_spots(const Scene& scene) {
    if (!scene.spots.empty() && !scene.disc)
        return {{"spot", "there is no [disc]", "in a disc only; disc.opacity = 0 shows the spots alone"}};
    Faults faults;
    for (std::size_t i = 0; i < scene.spots.size(); ++i)
        if (const double r = scene.spots[i].r; !(r > scene.disc->inner && r < scene.disc->outer))
            faults.push_back({section_label("spot", i) + ".r", fmt::format("{} is not within the disc", r),
                              fmt::format("({}, {})", scene.disc->inner, scene.disc->outer)});
    return faults;
}

// Films may leave the places where there is a scale.
Faults check_scale_bar(const Scene& scene, const World& world) {
    const std::string key = "picture.scale_bar";
    if (scene.picture.scale_bar == ScaleBar::kOff || !world) return {};
    if (scene.picture.scale_bar == ScaleBar::kAngle)
        for (const auto& [needed, there] : {std::pair{"object.mass_suns", scene.object.mass().has_value()},
                                            {"object.distance_pc", scene.object.distance().has_value()}})
            if (!there)
                return {{needed, "missing, but scale_bar = \"uas\"", "both mass_suns and distance_pc, or a name", key}};
    if (!has_scale(*world))
        return {{key, fmt::format("metric \"{}\" has no r_s", scene.spacetime.metric), "off, or another metric"}};
    if (!scene.path && !picture_scale(*world, scene.camera))
        return {{key, "this camera's picture has no single scale",
                 fmt::format("cameras at rest that look at the centre from r >= {}", kLeastScaleRadius)}};
    return {};
}

// Whether the critical curve that a [zoom] is about is there.
Faults check_zoom(const Scene& scene, const World& world) {
    if (!scene.camera.zoom || !world) return {};
    const auto view = ring_view(*world, scene.camera, scene.light);
    return view ? Faults{} : one(view.error(), "zoom.depth");
}

// A ball on a path by formulas: whether it is in the hole, from which nothing comes out, at a time that is seen.
Faults check_ball_path(const Scene& scene, const World& world, const BallMotionAt& motion, const std::string& key) {
    constexpr double kBent = 60.0;  // r_s/c: as render/ball_paths.cpp, light after ten half turns
    constexpr int kSamples = 2000;
    const double horizon = world->horizon_radius().value_or(0.0);
    if (unseen_radius(scene, world->horizon_radius()) == 0.0) return {};
    const double to = scene.time - (scene.camera.r - horizon), step = (scene.camera.r + kBent) / kSamples;
    double first = NAN, last = NAN;
    for (int i = 0; i <= kSamples; ++i) {
        const double t = to - i * step;
        if (!(length(motion(t).place) < horizon)) continue;
        if (std::isnan(last)) last = t;
        first = t;
    }
    if (std::isnan(last)) return {};
    return {
        {key,
         fmt::format("the middle of the ball is inside the horizon, r = {:.4g}, from t = {:.4g} to {:.4g}, which is "
                     "seen at time {}; it cannot be seen there",
                     horizon, first, last, scene.time),
         "a path outside the horizon at times that are seen"}};
}

// What moves: whether it can, and whether its light's delay is known there.
Faults check_motion(const Scene& scene, const World& world, const std::string& metric, bool delay) {
    const auto moving = moving_parts(scene);
    if (!world || moving.empty()) return {};
    Faults faults;
    if (delay && !world->knows_light_time())
        faults.push_back({moving.front(), fmt::format("light-travel time is not available in metric \"{}\"", metric),
                          "light.delay = \"off\", or another metric"});
    for (std::size_t i = 0; i < scene.spots.size() && scene.disc; ++i)
        if (!circular_orbit(*world, scene.spots[i].r, sense_about(*world, scene.spots[i].sense)))
            faults.push_back({section_label("spot", i) + ".r", fmt::format("no circular orbit at {}", scene.spots[i].r),
                              "r outside the photon sphere"});
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const auto* ball = std::get_if<BallSpec>(&scene.bodies[i].shape);
        if (ball == nullptr || !ball->moves()) continue;
        const std::string section = body_section(scene, i), motion = section + ".motion";
        if (world->by_proper_length())
            faults.push_back({motion, "motion is not supported in a wormhole", "still"});
        else if (const auto moves = ball_motion(*world, *ball); !moves)
            append(faults, one(within(section, moves.error()), motion));
        else if (ball->motion == BallMotion::kPath)
            append(faults, check_ball_path(scene, world, *moves, motion));
    }
    return faults;
}

// Faults of a split picture's right half: keys of its spacetime are those of [split], and what names another key says which half it is of.
Faults of_right_half(Faults faults) {
    constexpr std::string_view kWorld = "spacetime";
    const auto renamed = [&](std::string& key) {
        const bool its = key == kWorld || key.starts_with("spacetime.");
        if (its) key = "split" + key.substr(kWorld.size());
        return its;
    };
    for (SceneFault& fault : faults) {
        if (!renamed(fault.key)) fault.what += " in the right half ([split])";
        if (!renamed(fault.at) && fault.at.empty()) fault.at = "split";
    }
    return faults;
}

}  // namespace

void settle_size(Scene& scene, const GivenKeys& given) {
    if (projection_of(scene.camera).faces && !given("camera.size"))
        scene.camera.width = kCubeWidth, scene.camera.height = kCubeWidth / 3 * 2;
}

void settle_defaults(Scene& scene, const GivenKeys& given) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (Material& material = scene.bodies[i].material;
            (material.texture == TextureKind::kImage || material.temperature_K) &&
            !given(body_section(scene, i) + ".colour"))
            material.colour = {1, 1, 1};
    if (scene.disc && scene.disc->material.texture == TextureKind::kGas &&
        scene.disc->emission == DiscEmission::kThermal && !given("disc.colour"))
        scene.disc->material.colour = {1, 1, 1};
    if (has_dumps(scene)) settle_dumps(scene.medium->grid);
    if (scene.path && scene.path->keys.size() > 1 && !given("path.frames"))
        scene.path->frames = frames_of_keys(*scene.path);
}

std::vector<SceneFault> check_camera(const Scene& scene, const GivenKeys& given) {
    Faults faults = check_keys(kCamera, kCamera, scene, given);
    for (const char* other : {"camera.plane_width", "camera.focal_distance"})
        if (given("camera.fov") && given(other))
            faults.push_back({"camera.fov", fmt::format("says the same as {}", other),
                              "either fov, or plane_width and focal_distance", other});
    append(faults, check_lens(scene));
    append(faults, check_warp(scene));
    append(faults, check_place(scene, "spacetime", scene.spacetime));
    append(faults, check_stereo(scene));
    const World world = world_of(scene.spacetime);
    if (const Status parts = world ? check_light_parts(*world, scene) : Done{}; !parts)
        append(faults, one(parts.error(), "camera.observer"));
    if (scene.split) append(faults, of_right_half(check_place(scene, "split", *scene.split)));
    return faults;
}

std::vector<SceneFault> check_parts(const Scene& scene, const GivenKeys& given) {
    const World world = world_of(scene.spacetime), other = scene.split ? world_of(*scene.split) : nullptr;
    Faults faults = check_path(scene);
    append(faults, check_disc(scene, world, given));
    append(faults, emissivity_faults(world.get(), scene, given));
    append(faults, disc_shape_faults(world.get(), scene, given));
    if (other && disc_warps(scene)) append(faults, of_right_half(disc_shape_faults(other.get(), scene, given)));
    if (other) append(faults, of_right_half(emissivity_faults(other.get(), scene, given)));
    if (world) append(faults, disc_orbit_faults(*world, scene));
    if (other) append(faults, of_right_half(disc_orbit_faults(*other, scene)));
    append(faults, check_patterns(scene));
    append(faults, check_bodies(scene, world ? world->horizon_radius().value_or(0.0) : 0.0));
    if (world) append(faults, metric_faults(*world, scene));
    if (other) append(faults, of_right_half(metric_faults(*other, scene)));
    append(faults, check_other_keys(scene, given));
    append(faults, check_spots(scene));
    if (!faults.empty()) return faults;
    append(faults, check_scale_bar(scene, world));
    append(faults, check_zoom(scene, world));
    append(faults, of_right_half(check_zoom(scene, other)));
    if (!faults.empty()) return faults;
    faults = check_motion(scene, world, scene.spacetime.metric, scene.light.delay);
    if (scene.split)
        append(faults,
               of_right_half(check_motion(scene, other, scene.split->metric, scene.light.delay && scene.split_delay)));
    return faults;
}

}  // namespace nullscope
