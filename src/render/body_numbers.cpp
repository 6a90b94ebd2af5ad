#include "render/body_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/black_body.h"
#include "plan/body_kind.h"
#include "plan/glow.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/named_surface.h"
#include "scene/orbit_sense.h"
#include "shaderlib/body_text.h"
#include "shaderlib/glow_text.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/leaning_circle.h"
#include "table/disc_light.h"
#include "table/disc_rate.h"

namespace nullscope {
namespace {

void put_material(FrameVector& map, FrameVector& colour, FrameVector& second, const Material& material) {
    map = {std::cos(material.rotation), std::sin(material.rotation), static_cast<double>(material.columns),
           static_cast<double>(material.rows)};
    colour = {material.brightness * material.colour, material.limb};
    second = {material.brightness * material.second_colour, material.band_latitude};
}

// Direction, world axes, and what the side away from it has of the light.
FrameVector sun_of(const Material& material) {
    const double across = std::cos(material.sun_latitude);
    return {{across * std::cos(material.sun_longitude), across * std::sin(material.sun_longitude),
             std::sin(material.sun_latitude)},
            material.night};
}

struct Silhouette {
    double sine, cosine;
};
// Of the angle from the outward radial under which a sphere's edge is seen. Sine -1 where only captured rays reach it: a sphere within
// the photon sphere.
Silhouette silhouette(const Spacetime& spacetime, const RayFamily* family, double camera_r, double radius) {
    const auto photon_sphere = spacetime.photon_sphere();
    if (photon_sphere && radius <= photon_sphere->radius) return {-1.0, 0.0};
    if (family == nullptr) return {radius / camera_r, -std::sqrt((camera_r - radius) * (camera_r + radius)) / camera_r};
    const double t = family->half_tangent_inward(std::sqrt(spacetime.lapse_squared(radius)) / radius),
                 by = 1.0 / (1.0 / t + t);
    return {2.0 * by, (1.0 / t - t) * by};
}

bool found_by_formula(const Body& body, const Spacetime& spacetime) {  // a still sphere on a planar path
    const auto* sphere = std::get_if<SphereSpec>(&body.shape);
    return sphere != nullptr && spacetime.planar_rays() && !(sphere->amplitude > 0.0);
}

// A sphere that keeps its size is where it was, whatever its surface does.
bool turns_in_place(const Body& body) {
    const auto* sphere = std::get_if<SphereSpec>(&body.shape);
    return sphere != nullptr && !(sphere->amplitude > 0.0);
}

// A body's form, as its file in shaders/object has it.
struct FormOf {
    const FramePlan& plan;
    const RayFamily* family;
    const BallPath* path;  // of a ball that moves
    const SurfaceClearances& clearances;
    FrameVector operator()(const SphereSpec& sphere) const {
        if (sphere.amplitude > 0.0) {
            const double pulse = 2.0 * M_PI / sphere.period;
            return {sphere.radius, sphere.amplitude, std::remainder(pulse * late_time(plan), 2.0 * M_PI), pulse};
        }
        const Silhouette edge = silhouette(*plan.light, family, plan.scene.camera.r, sphere.radius);
        return {sphere.radius, 1.0 / sphere.radius, edge.sine, edge.cosine};
    }
    FrameVector operator()(const CylinderSpec& c) const { return {c.inner, c.outer, c.height, 0}; }
    FrameVector operator()(const BallSpec& ball) const {
        if (path != nullptr)  // from the scene's time on to late_time()
            return {path->from - (plan.scene.time - late_time(plan)), 1.0 / path->step, path->speed, ball.radius};
        return {ball.position, ball.radius};
    }
    FrameVector operator()(const SurfaceSpec& s) const {
        return {s.bound, 2 * s.bound / s.steps, static_cast<double>(clearances.first_cell(solid_of(s))),
                late_time(plan)};
    }
};

constexpr double kCopies = 4096.0;  // DISC_COPIES of shaders/object/disc_flow.glsl

// shaders/object/spot.glsl
std::array<FrameVector, 3> spot_numbers(const SpotSpec& spot, const FramePlan& plan) {
    const LightSpec& light = plan.scene.light;
    const Sense sense = sense_about(*plan.matter, spot.sense);
    const auto orbit = circular_orbit(*plan.matter, spot.r, sense);
    const double tilt = plan.scene.disc ? plan.scene.disc->lean.tilt : 0.0;
    const double omega = leaning_rate(*plan.matter, spot.r, sense, tilt).value_or(0.0),
                 lapse = std::sqrt(plan.matter->lapse_squared(spot.r));
    // As disc_flow_row: g's two parts, and rays of flat space.
    double u_t = orbit ? orbit->u_t : 1.0 / lapse, u_phi = u_t * omega;
    if (!light.doppler) u_t = 1.0 / lapse, u_phi = 0.0;
    if (!light.gravity) u_t *= lapse, u_phi *= lapse;
    if (!light.lensing) u_phi /= lapse;
    if (plan.effects.contains(Effect::kDiscLean)) u_t = 1.0, u_phi = omega;
    const auto lapses = disc_lapses(*plan.matter, spot.r, {light.doppler, light.gravity, !light.lensing});
    return {{{spot.r, std::remainder(spot.phase + omega * late_time(plan), 2.0 * M_PI), omega, 2.0 * M_PI / spot.count},
             {spot.size * spot.size, spot.brightness, std::log2(spot.temperature_K),
              log2_brightness(spot.temperature_K, light.bolometric)},
             {u_t, u_phi, lapses[0], lapses[1]}}};
}

// shaders/object/glow.glsl
std::vector<FrameVector> glow_numbers(const FramePlan& plan) {
    std::vector<FrameVector> numbers;
    const LightSpec& light = plan.scene.light;
    const LapseForm lapse = lapse_form(*plan.matter).value_or(LapseForm{0, 0});
    for (const std::size_t i : shader_bodies(plan.scene)) {
        const Material& material = plan.scene.bodies[i].material;
        if (!material.temperature_K) continue;
        const double kelvin = *material.temperature_K,
                     parts = (light.gravity ? 1.0 : 0.0) + (light.doppler ? 2.0 : 0.0);
        Vec3 factor{1, 1, 1};
        if (material.texture == TextureKind::kImage) {  // its primaries change as those of the black body do
            const Vec3 xyz = black_body_xyz(kelvin), own = into_gamut(rec709_from_xyz(xyz / xyz.y));
            const auto over = [](double of) { return of > 0.0 ? 1.0 / of : 0.0; };
            factor = {over(own.x), over(own.y), over(own.z)};
        }
        numbers.insert(numbers.end(), {{factor, std::log2(kelvin)},
                                       {log2_brightness(kelvin, light.bolometric), lapse.sum, lapse.product, parts}});
    }
    return numbers;
}

// shaders/object/sphere_turn.glsl and caps.glsl
std::vector<FrameVector> turn_numbers(const FramePlan& plan) {
    std::vector<FrameVector> numbers;
    if (sphere_turns(plan.scene)) {
        const double rate = std::get<SphereSpec>(seen_sphere(plan.scene)->shape).spin_rate;
        numbers.push_back({rate, std::remainder(rate * late_time(plan), 2.0 * M_PI), 0, 0});
    }
    if (!has_caps(plan.scene)) return numbers;
    for (const CapSpec& cap : plan.scene.caps) {
        constexpr double kWhole = 4.0;
        const double across = std::sin(cap.colatitude),
                     chord = cap.radius < M_PI ? 2.0 * std::sin(0.5 * cap.radius) : kWhole;
        const Vec3 middle{across * std::cos(cap.azimuth), across * std::sin(cap.azimuth), std::cos(cap.colatitude)};
        numbers.push_back({middle, chord});
        numbers.push_back({cap.brightness * cap.colour, std::log2(cap.temperature_K)});
    }
    return numbers;
}

}  // namespace

SolidFormula solid_of(const SurfaceSpec& surface) { return {surface_shape(surface), surface.bound}; }

void put_march(FrameData& frame, const FramePlan& plan, const BallPaths& paths) {
    constexpr double kNowhere = 1e30;
    constexpr double kMarchStep = 1.0 / 32;  // the shortest, of the thinnest body; a surface says its own
    const Spacetime& spacetime = *plan.light;
    double reaches[2] = {0.0, 0.0}, thinnest = 1e30, least_radius = 1e30, height = 0.0;  // near, far
    double fastest = 0.0;
    bool moves = false;
    for (const std::size_t i : shader_bodies(plan.scene)) {
        const Body& body = plan.scene.bodies[i];
        if (found_by_formula(body, spacetime)) continue;
        BodyExtent extent = kind_of(body).extent(body);
        const bool comes = kind_of(body).moves(body) != nullptr && !turns_in_place(body);
        moves = moves || comes;
        if (const auto ball = paths.balls.find(i); ball != paths.balls.end()) {
            const BallPath& path = ball->second;
            extent.from = std::max(path.least_radius, 0.0), extent.to = path.reach, extent.height = path.height;
            fastest = std::max(fastest, path.speed);
        } else if (comes) {
            fastest = std::max(fastest, 1.0);  // a pulsation, a formula of t
        }
        if (std::holds_alternative<SurfaceSpec>(body.shape)) extent.thinnest /= kMarchStep;
        reaches[body.far] = std::max(reaches[body.far], extent.to), least_radius = std::min(least_radius, extent.from);
        height = std::max(height, std::min(extent.height, extent.to));
        thinnest = std::min(thinnest, extent.thinnest);
    }
    // A body beside a ray covers a part of its pixel from two pixels off.
    const CameraSpec& camera = plan.scene.camera;
    const auto beside = [&](double reach) { return 2.0 * camera.pixel() * (std::fabs(camera.r) + reach); };
    const auto with_margin = [&](double reach) { return 1.001 * reach + 4 * kMarchStep * thinnest; };
    const auto reach = [&](bool far) {
        return with_margin(reaches[far]) + (reaches[far] > 0.0 ? beside(reaches[far]) : 0.0);
    };
    const double least = 0.999 * least_radius;
    frame.march = {reach(false), kMarchStep * thinnest, reach(true), fastest};
    const double unseen = unseen_radius(plan.scene, spacetime.horizon_radius());
    frame.march_shell = {with_margin(height) + beside(reaches[0]), std::max(least - beside(reaches[0]), 0.0),
                         spacetime.planar_rays() ? 0.0 : std::min(least, innermost_light_orbit(spacetime)),
                         moves && unseen > 0.0 ? unseen : -kNowhere};
}

std::vector<FrameVector> object_numbers(const FramePlan& plan, const RayFamily* family, const BallPaths& paths,
                                        const SurfaceClearances& clearances) {
    std::vector<FrameVector> numbers;
    for (const std::size_t i : shader_bodies(plan.scene)) {
        const Body& body = plan.scene.bodies[i];
        const auto ball = paths.balls.find(i);
        const BallPath* path = ball != paths.balls.end() ? &ball->second : nullptr;
        FrameVector map, colour, second;
        put_material(map, colour, second, body.material);
        numbers.insert(numbers.end(), {std::visit(FormOf{plan, family, path, clearances}, body.shape), map, colour,
                                       second, sun_of(body.material)});
    }
    if (plan.scene.disc)
        for (const SpotSpec& spot : plan.scene.spots)
            for (const FrameVector& v : spot_numbers(spot, plan)) numbers.push_back(v);
    for (const FrameVector& v : glow_numbers(plan)) numbers.push_back(v);
    for (const FrameVector& v : turn_numbers(plan)) numbers.push_back(v);
    return numbers;
}

void put_patterns(FrameData& frame, const Scene& scene) {
    if (scene.disc) {  // its brightness is disc_surface's
        Material material = scene.disc->material;
        material.rotation = scene.disc->rotation;
        put_material(frame.disc_material_map, frame.disc_material_colour, frame.disc_material_second, material);
    }
    const double cy = std::cos(scene.sky.yaw), sy = std::sin(scene.sky.yaw), ct = std::cos(scene.sky.tilt),
                 st = std::sin(scene.sky.tilt);
    frame.sky_pattern_x = {cy, sy, 0, 0};  // columns of R_z(yaw) R_x(tilt)
    frame.sky_pattern_y = {-sy * ct, cy * ct, st, 0};
    frame.sky_pattern_z = {sy * st, -cy * st, ct, 0};
    Material dome = scene.sky.material;
    dome.brightness = scene.sky.brightness;
    put_material(frame.sky_pattern_map, frame.sky_pattern_colour, frame.sky_pattern_second, dome);
}

void put_moving(FrameData& frame, const FramePlan& plan) {
    const auto& disc = plan.scene.disc;
    if (!disc || disc->flow != DiscFlowKind::kKepler) return;
    const auto [first, second] = circular_rate_numbers(*plan.matter);
    const double lives = late_time(plan) / disc->flow_life;
    const double copy = std::floor(lives);
    frame.disc_winding = {lives - copy, 1.0 / disc->flow_life, first, second};
    frame.disc_copy = {copy - kCopies * std::floor(copy / kCopies), sign_of(sense_about(*plan.matter, disc->sense)), 0,
                       0};
    if (!plan.effects.contains(Effect::kRingRates)) return;
    const DiscRate rate = disc_rate(*plan.matter, disc->inner, disc->outer);
    const auto& t = rate.terms;
    frame.disc_rate_span = {rate.middle, rate.per_half, 0, 0};
    frame.disc_rate_0 = {t[0], t[1], t[2], t[3]};
    frame.disc_rate_1 = {t[4], t[5], t[6], t[7]};
    frame.disc_rate_2 = {t[8], t[9], t[10], t[11]};
}

}  // namespace nullscope
