#include "render/frame_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "camera/pose.h"
#include "camera/spin_forms.h"
#include "light/black_body.h"
#include "render/moving_numbers.h"
#include "scene/pixel_angle.h"
#include "scene/sides.h"
#include "sky/packed_sky.h"
#include "sky/point_stars.h"
#include "table/critical_images.h"
#include "table/disc_light.h"
#include "table/star_lens.h"

namespace nullscope {
namespace {

constexpr double kInPlane =
    1e-12;  // |cos theta| below which a camera stands in the disc's plane (interfaces: rays out)

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Members of FrameData in the order of the block.
class BlockWriter {
public:
    void put(double x, double y, double z, double w) {
        for (const double value : {x, y, z, w}) numbers_[next_++] = value;
    }
    void put(Vec3 v, double w) { put(v.x, v.y, v.z, w); }
    FrameNumbers numbers() const { return numbers_; }

private:
    FrameNumbers numbers_{};
    std::size_t next_ = 0;
};

void put_look(BlockWriter& block, const BodyLook& look) {
    block.put(std::cos(look.rotation), std::sin(look.rotation), look.columns, look.rows);
    block.put(look.brightness * look.colour, look.limb);
    block.put(look.brightness * look.second_colour, look.band_latitude);
}

struct Silhouette {
    double sine, cosine;
};
// Of the angle from the outward radial under which a sphere's edge is seen. Sine -1 where only captured rays reach it: a sphere within
// the photon sphere.
Silhouette silhouette(const Spacetime& spacetime, const RayFan* fan, double camera_r, double radius) {
    const auto photon_sphere = spacetime.photon_sphere();
    if (photon_sphere && radius <= photon_sphere->radius) return {-1.0, 0.0};
    if (fan == nullptr) return {radius / camera_r, -std::sqrt((camera_r - radius) * (camera_r + radius)) / camera_r};
    const double t = fan->half_tangent_inward(std::sqrt(spacetime.lapse_squared(radius)) / radius),
                 by = 1.0 / (1.0 / t + t);
    return {2.0 * by, (1.0 / t - t) * by};
}

// Of a hole with a = spin, r_s: light that is on its way in there does not turn any more (Bardeen, Press and Teukolsky 1972).
double innermost_photon_orbit(double spin) { return 1.0 + std::cos(2.0 / 3.0 * std::acos(-2.0 * std::fabs(spin))); }

// Radii about the centre between which all bodies lie that are found by strides, and the shortest stride: a thirtieth of the thinnest.
void put_march(BlockWriter& block, const Scene& scene, double spin, const BallPath* ball_path) {
    constexpr double kStride = 1.0 / 32;
    double reaches[2] = {0.0, 0.0}, thinnest = 1e30, ground = 1e30;  // near, far
    const auto holds = [&](bool far, double radius, double from) {
        reaches[far] = std::max(reaches[far], radius), ground = std::min(ground, from);
    };
    if (const auto& c = scene.cylinder) {
        holds(c->far, std::hypot(c->outer, c->height), c->inner);
        thinnest = std::min({thinnest, 2 * c->height, c->outer - c->inner});
    }
    if (const auto& b = scene.ball) {
        holds(b->far, ball_path != nullptr ? ball_path->reach : length(b->position) + b->radius,
              ball_path != nullptr ? std::max(ball_path->ground, 0.0) : length(b->position) - b->radius);
        thinnest = std::min(thinnest, b->radius);
    }
    if (scene.sphere && (spin != 0.0 || scene.sphere->swing > 0.0)) {
        holds(false, scene.sphere->radius * (1.0 + scene.sphere->swing),
              scene.sphere->radius * (1.0 - scene.sphere->swing));
        thinnest = std::min(thinnest, scene.sphere->radius * (1.0 - scene.sphere->swing));
    }
    if (const auto& f = scene.surface) {
        holds(f->far, f->bound, 0.0);
        thinnest = std::min(thinnest, 2 * f->bound / f->steps / kStride);
    }
    const auto with_margin = [&](double reach) { return 1.001 * reach + 4 * kStride * thinnest; };
    const double least = 0.999 * ground;
    block.put(with_margin(reaches[0]), kStride * thinnest, spin != 0.0 ? least : with_margin(reaches[1]),
              std::min(least, innermost_photon_orbit(spin)));
}

void put_bodies(BlockWriter& block, const Scene& scene, const Spacetime& spacetime, const RayFan* fan,
                const BallPath* ball_path) {
    const SphereSpec sphere = scene.sphere.value_or(SphereSpec{});
    const bool pulses = sphere.swing > 0.0;  // object/pulse.glsl
    const Silhouette edge =
        scene.sphere && !pulses ? silhouette(spacetime, fan, scene.camera.r, sphere.radius) : Silhouette{};
    const double pulse = 2.0 * M_PI / sphere.period;
    if (pulses)
        block.put(sphere.radius, sphere.swing, std::remainder(pulse * scene.time, 2.0 * M_PI), pulse);
    else
        block.put(sphere.radius, 1.0 / sphere.radius, edge.sine, edge.cosine);
    put_look(block, sphere.look);
    const CylinderSpec cylinder = scene.cylinder.value_or(CylinderSpec{});
    block.put(cylinder.inner, cylinder.outer, cylinder.height, 0);
    put_look(block, cylinder.look);
    const BallSpec ball = scene.ball.value_or(BallSpec{});
    block.put(ball.position, ball.radius);
    put_look(block, ball.look);
    const SurfaceSpec surface = scene.surface.value_or(SurfaceSpec{});
    constexpr double kDifference = 1e-3;  // of the bound: gradients by differences keep half of a float's digits
    block.put(surface.bound, 2 * surface.bound / surface.steps, kDifference * surface.bound, scene.time);
    put_look(block, surface.look);
    put_march(block, scene, spacetime.spin(), ball_path);
}

// What the disc and the sky are painted with. A disc's brightness is disc_look's.
void put_coats(BlockWriter& block, const Scene& scene) {
    const DiscSpec disc = scene.disc.value_or(DiscSpec{});
    BodyLook coat = disc.look;
    coat.rotation = disc.rotation;
    put_look(block, coat);
    const double cy = std::cos(scene.sky.yaw), sy = std::sin(scene.sky.yaw), ct = std::cos(scene.sky.tilt),
                 st = std::sin(scene.sky.tilt);
    block.put({cy, sy, 0}, 0);  // columns of R_z(yaw) R_x(tilt)
    block.put({-sy * ct, cy * ct, st}, 0);
    block.put({sy * st, -cy * st, ct}, 0);
    BodyLook dome = scene.sky.look;
    dome.brightness = scene.sky.brightness;
    put_look(block, dome);
}

void put_spin(BlockWriter& block, const CameraSpec& camera, const Spacetime& spacetime, const Observer& observer) {
    const SpinForms forms = spin_forms(spin_place(spacetime, camera.r, camera.theta), {observer.frame, observer.swirl});
    const double a = spacetime.spin(), outer = *spacetime.horizon_radius(), inner = inner_horizon(spacetime);
    block.put(a, a * a, outer, inner);
    block.put(forms.energy.constant, forms.energy.radial, forms.energy.around, forms.p_theta);
    block.put(forms.across.constant, forms.across.radial, forms.across.around, forms.carter);
    block.put(forms.climb.constant, forms.climb.radial, forms.climb.around, forms.carter_slope);
    const double height = std::cos(camera.theta);
    block.put(std::sin(camera.theta), std::fabs(height) < kInPlane ? 0.0 : height, std::cos(camera.phi),
              std::sin(camera.phi));
    block.put(camera.r > outer ? azimuth_ahead(spacetime, camera.r) : 0.0, a / (outer - inner), 0, 0);
}

// Factor on the light of a sky of this temperature, where g is the same over all of it; for a moving camera one over the colour that
// it has without any shift, of luminance 1.
Vec3 sky_light(const LightSpec& light, double temperature_K, double g, bool moves) {
    const auto colour = [](double hue_K) {
        const Vec3 xyz = black_body_xyz(hue_K);
        return into_gamut(rec709_from_xyz(xyz / xyz.y));
    };
    const Vec3 own = colour(temperature_K),
               seen = moves ? Vec3{1, 1, 1} : colour(light.shift ? g * temperature_K : temperature_K);
    const double glow_K = light.beaming && !moves ? g * temperature_K : temperature_K;
    const double brighter =
        std::exp2(log2_brightness(glow_K, light.bolometric) - log2_brightness(temperature_K, light.bolometric));
    const auto factor = [&](double a, double b) { return b > 0.0 ? brighter * a / b : 0.0; };
    return {factor(seen.x, own.x), factor(seen.y, own.y), factor(seen.z, own.z)};
}

Fate inner_fate(InnerEnd end) {
    switch (end) {
        case InnerEnd::kOtherSky: return Fate::kOtherSide;
        case InnerEnd::kSurface: return Fate::kHit;
        case InnerEnd::kSameSky: return Fate::kEscaped;
        case InnerEnd::kHorizon: break;
    }
    return Fate::kCaptured;
}

}  // namespace

Status FrameTables::update(const Scene& scene) {
    bool rows_stale = false;
    if (spacetime_ == nullptr || !(spec_ == scene.spacetime) || lensing_ != scene.light.lensing) {
        auto made = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        if (!made) return made.error();
        matter_ = *made;
        spacetime_ = scene.light.lensing ? matter_ : *make_spacetime("minkowski", {});
        spec_ = scene.spacetime;
        lensing_ = scene.light.lensing;
        table_.reset();
        if (spacetime_->photon_sphere()) {
            const auto start = std::chrono::steady_clock::now();
            table_ = std::make_shared<DeflectionTable>(*spacetime_);
            table_ms_ = milliseconds_since(start);
        }
        rows_stale = true;
    }
    const auto observer = observer_of(*matter_, scene.camera);
    if (!observer) return observer.error();
    if (Status parts = check_light_parts(*matter_, scene); !parts) return parts.error();
    EffectSet wanted = effect_set(required_effects(scene));
    if (Status bodies = check_sides(*matter_, scene); !bodies) return bodies.error();
    if ((wanted.contains(Effect::kDisc) && !matter_->can_have_disc()) ||
        (has_solids(wanted) && !matter_->can_have_bodies()))
        return bad_input(fmt::format("metric \"{}\" has neither discs nor bodies; allowed: a scene without them",
                                     scene.spacetime.metric));
    // Ray data have delays wherever the shader can tell them.
    const bool straight = !wanted.contains(Effect::kLensing) && !wanted.contains(Effect::kSpin),
               known = straight || spacetime_->spin() != 0.0 || spacetime_->lapse_roots();
    if (delays_wanted_ && known) wanted.insert(Effect::kDelay);
    if (wanted.contains(Effect::kDelay) && !known) wanted.erase(Effect::kDelay);
    if (wanted.contains(Effect::kDelay) && !straight && spacetime_->has_inner_horizon())
        wanted.insert(Effect::kInnerHorizon);
    const auto orbits_of = [](const EffectSet& effects) {
        return meets_objects(effects) || effects.contains(Effect::kDelay);
    };
    const bool orbits = orbits_of(wanted), had_orbits = orbits_of(effects_);
    const bool delays = wanted.contains(Effect::kDelay), had_delays = effects_.contains(Effect::kDelay);
    const bool points = wanted.contains(Effect::kPointStars), had_points = effects_.contains(Effect::kPointStars);
    rows_stale = rows_stale || radius_ != scene.camera.r || !(frame_ == observer->frame) || (orbits && !had_orbits) ||
                 (delays && !had_delays) || (points && !had_points) ||
                 (fan_ && fan_->w0() != fan_for(scene, *observer).w0());
    effects_ = wanted;
    ball_path_.reset();
    if (wanted.contains(Effect::kBallPath)) {
        auto path = nullscope::ball_path(*matter_, scene);
        if (!path) return path.error();
        ball_path_ = std::move(*path);
    }
    if (((!orbits && had_orbits) || (!delays && had_delays) || (!points && had_points)) &&
        !rows_stale) {  // what nothing calls for any more goes, the strip stays
        if (!orbits) orbit_map_ = {};
        if (!delays) orbit_map_.delays = {};
        if (!points) star_lens_ = {};
        ++revision_;
    }
    if (!rows_stale) return Done{};
    radius_ = scene.camera.r;
    frame_ = observer->frame;
    fan_.reset();
    strip_ = {};
    orbit_map_ = {};
    star_lens_ = {};
    ++revision_;
    if (!effects_.contains(Effect::kLensing)) return Done{};
    const auto start = std::chrono::steady_clock::now();
    fan_ = fan_for(scene, *observer);
    strip_ = build_strip(*fan_);
    if (orbits) orbit_map_ = build_orbit_map(*fan_, delays);
    if (points) star_lens_ = star_lens_row(*fan_);
    rows_ms_ = milliseconds_since(start);
    return Done{};
}

RayFan FrameTables::fan_for(const Scene& scene, const Observer& observer) const {
    const double speed = scene.light.aberration ? length(observer.velocity) : 0.0,
                 squeeze = std::sqrt((1.0 - speed) / (1.0 + speed));
    return {spacetime_, table_, scene.camera.r, observer.frame, squeeze * smallest_pixel_angle(scene.camera)};
}

CoreInput FrameTables::core_input(const Scene& scene) const {
    CoreInput input;
    input.frame = frame_numbers(scene, *spacetime_, fan(), {}, &*matter_, ball_path());
    input.strip = strip_.sky.view();
    input.ends = strip_.ends.view();
    input.orbit = orbit_map_.places.view();
    input.delay = orbit_map_.delays.view();
    input.lensing = effects_.contains(Effect::kLensing);
    input.spin = effects_.contains(Effect::kSpin);
    input.spin_fall = effects_.contains(Effect::kSpinFall);
    input.spin_delay = input.spin && effects_.contains(Effect::kDelay);
    input.aberration = effects_.contains(Effect::kAberration);
    return input;
}

FrameNumbers frame_numbers(const Scene& scene, const Spacetime& spacetime, const RayFan* fan,
                           const TextureFacts& textures, const Spacetime* other_matter, const BallPath* ball_path) {
    const Spacetime& matter = other_matter != nullptr ? *other_matter : spacetime;
    const CameraSpec& camera = scene.camera;
    const Mat3 world = world_from_static(camera.theta, camera.phi);
    const Observer observer = *observer_of(matter, camera);
    // Where light goes straight its frame is at rest and A = 1. What g then lacks, or has too much without gravity's part, is a factor.
    const bool straight = &matter != &spacetime;
    const RadialFrame frame = straight || spacetime.spin() != 0.0 ? RadialFrame{} : observer.frame;
    const double g_gravity =
        scene.light.gravity ? 1.0 / observer.frame.energy() : 1.0;  // switched off with observers at rest only
    const double g_factor = straight || !scene.light.gravity ? g_gravity * frame.energy() : 1.0;
    const Mat3 axes = observer.turn * static_from_camera(camera);
    const double pixel = camera.plane_width / camera.width / camera.focal_distance;
    const Vec3 local[3] = {-axes.c, pixel * axes.a, pixel * axes.b};  // forward, a pixel to the right, a pixel up
    BlockWriter block;
    block.put(camera.width, camera.height, pixel, std::exp2(camera.exposure_ev));
    const bool spins = spacetime.spin() != 0.0;
    const Mat3 shown = spins ? Mat3{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : world;  // axes of look directions and of motion
    for (const Vec3 v : local) block.put(shown * v, 0);
    const double off_axis = std::hypot(local[0].y, local[0].z);
    const Vec3 meridian = off_axis > 0.0 ? Vec3{0, local[0].y, local[0].z} / off_axis : Vec3{0, 1, 0}, radial{1, 0, 0};
    const Vec3 transverse = cross(radial, meridian);
    const double critical_cosine = fan != nullptr ? fan->critical_cosine() : -1.0;
    const double critical_sine = fan != nullptr ? fan->critical_sine() : 0.0;
    for (const Vec3 v : local)
        block.put(dot(v, meridian), dot(v, transverse), v.x, critical_sine * v.x - critical_cosine * dot(v, meridian));
    for (const Vec3 v : {radial, meridian, transverse}) block.put(world * v, v == radial ? g_factor : 0.0);
    const auto horizon = spacetime.horizon_radius();
    const Fate lost = horizon && camera.r <= *horizon ? Fate::kNoSky : inner_fate(spacetime.inner_end());
    block.put(frame.energy(), 1.0 / matter.areal_radius(camera.r), frame.infall(), static_cast<double>(lost));
    if (fan != nullptr)
        block.put(critical_cosine, critical_sine, 1.0 / fan->w0(), fan->octaves(Segment::kSky));
    else
        block.put(0, 0, 0, 0);
    if (fan != nullptr) {
        const auto series = fan->has_table() ? fan->table().series() : DeflectionTable::Series{};
        const int captured = fan->octaves(Segment::kSky) + fan->octaves(Segment::kCaptured);
        const bool back = spacetime.inner_end() == InnerEnd::kSameSky;
        block.put(std::sin(fan->critical_angle()), std::cos(fan->chi0()), series.a0, series.a1);
        block.put(series.a2, fan->chi0(), back ? captured : 0, back ? std::tan(0.25 * fan->critical_angle()) : 0);
    } else {
        block.put(0, 0, 0, 0);
        block.put(0, 0, 0, 0);
    }
    const auto sky_K = scene.sky.temperature_K;
    const double speed = length(observer.velocity), stretch = std::sqrt((1.0 + speed) / (1.0 - speed));
    block.put(speed > 0.0 ? shown * (observer.velocity / speed) : Vec3{1, 0, 0},
              scene.light.aberration ? stretch : 1.0);
    block.put(scene.light.doppler ? stretch : 1.0, sky_K ? log2_brightness(*sky_K, scene.light.bolometric) : 0.0, 0, 0);
    const int sky_size = std::max(textures.sky_size, 1);
    if (textures.two_skies)
        block.put(0.5 * sky_size, sky_levels(sky_size, true) - 1, 1.0, 0.5 * sky_size / bordered_size(sky_size));
    else
        block.put(0.5 * textures.sky_size, std::log2(sky_size), 1.0, 0);
    if (sky_K)
        block.put(sky_light(scene.light, *sky_K, g_gravity, motion_is_seen(matter, scene)), std::log2(*sky_K));
    else
        block.put(1, 1, 1, 0);
    const double height = std::cos(camera.theta);
    block.put({0, 0, 1}, std::fabs(height) < kInPlane ? 0.0 : height);
    const DiscSpec disc = scene.disc.value_or(DiscSpec{});
    const double inner = scene.disc ? disc.inner : 1e30, outer = scene.disc ? disc.outer : 0.0;
    block.put({1, 0, 0}, inner);
    block.put({0, 1, 0}, outer);
    block.put(std::cos(disc.rotation) / (2 * disc.outer), std::sin(disc.rotation) / (2 * disc.outer),
              textures.disc_width / (2 * disc.outer), std::log2(std::max(textures.disc_width, 1)));
    block.put(disc.opacity, disc.edge, disc.brightness, disc.passed);
    const CriticalImages images =
        fan != nullptr && scene.disc ? critical_images(*fan, disc.inner, disc.outer) : CriticalImages{};
    block.put(images.inner, images.outer, images.per_angle * M_LOG2E, images.from_angle);
    if (disc.emission == DiscEmission::kThermal)
        block.put(1.0 / disc.inner, kDiscFlowCells / std::log(disc.outer / disc.inner), std::log2(disc.temperature_K),
                  log2_brightness(disc.temperature_K, scene.light.bolometric));
    else
        block.put(0, 0, 0, 0);
    block.put(point_peak(), 2.0 * kPointSigma_px * kPointSigma_px * M_LN2, 1.0 / kFaintestPoint, kPointMargin_px);
    block.put(M_LOG2E / (2.0 * kPointSigma_px * kPointSigma_px), 0, 0, 0);
    block.put(scene.picture.bloom, 0, 0, 0);
    put_bodies(block, scene, spacetime, fan, ball_path);
    put_coats(block, scene);
    for (const auto& row : moving_numbers(scene, spacetime, matter, ball_path))
        block.put(row[0], row[1], row[2], row[3]);
    if (spins)
        put_spin(block, camera, spacetime, observer);
    else
        for (int i = 0; i < 6; ++i) block.put(0, 0, 0, 0);
    if (spacetime.by_proper_length())
        block.put(spacetime.length_unit(), spacetime.logarithm_length() / spacetime.length_unit(), 0, 0);
    else
        block.put(0, 0, 0, 0);
    return block.numbers();
}

}  // namespace nullscope
