#include "render/frame_numbers.h"

#include <algorithm>
#include <cmath>

#include "base/rounding.h"
#include "light/black_body.h"
#include "observer/pose.h"
#include "observer/screen_form.h"
#include "render/body_numbers.h"
#include "render/medium_numbers.h"
#include "scene/disc_shape.h"
#include "scene/orbit_sense.h"
#include "scene/projection.h"
#include "scene/ray.h"
#include "scene/warp_mesh.h"
#include "sky/packed_sky.h"
#include "sky/point_stars.h"
#include "table/disc_light.h"

namespace nullscope {
namespace {

// |cos theta| below which a camera stands in the disc's plane (interfaces: rays out)
constexpr double kInPlane = 1e-12;

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

// Directions of view, in world axes (shown) and in those of the ray's plane.
void put_view(FrameData& frame, const FramePlan& plan, const Mat3& shown, const Mat3& world, const RayFamily* family,
              double g_factor) {
    const Observer& observer = plan.observer;
    const CameraSpec& camera = plan.scene.camera;
    const Mat3 axes = observer.turn * static_from_camera(camera);
    const double pixel = camera.pixel();
    const Vec3 ahead = -axes.c, right = pixel * axes.a, up = pixel * axes.b;  // the last two: a pixel
    frame.image = {static_cast<double>(camera.width), static_cast<double>(camera.height), pixel,
                   std::exp2(camera.exposure_ev)};
    const auto [right_px, down_px] = line_of_sight(camera);
    frame.sight = {right_px, camera.height - down_px, camera.pixel_aspect, pixel * std::sqrt(camera.pixel_aspect)};
    frame.projection = {static_cast<double>(camera.projection), shown_px(camera), turn_px(camera) * camera.pixel_aspect,
                        0};
    frame.warp = {0.5 * camera.whole_height(), camera.shift_x * camera.whole_width() * camera.pixel_aspect,
                  camera.shift_y * camera.whole_height(),
                  camera.warp_intensity == WarpIntensity::kDisplay ? kDisplayPower : 0.0};
    frame.ray_0 = {direction_without_rounding(shown * ahead), 0};
    frame.ray_x = {direction_without_rounding(shown * right), 0};
    frame.ray_y = {direction_without_rounding(shown * up), 0};
    // A zoom's directions as the observer at rest sees them: not yet of unit length, and linear in the unit vector before that.
    const bool aberrates = plan.ring && plan.scene.light.aberration;
    const Vec3 motion = aberrates ? observer.velocity : Vec3{};
    const double speed = length(motion), gamma = 1.0 / std::sqrt((1.0 - speed) * (1.0 + speed));
    const auto at_rest = [&](Vec3 v, double length) {
        return v + (gamma * gamma / (1.0 + gamma) * dot(motion, v) - gamma * length) * motion;
    };
    const auto weight = [&](Vec3 v, double length) { return gamma * (length - dot(motion, v)); };
    const Vec3 middle = at_rest(ahead, 1.0);
    const double off_axis = std::hypot(middle.y, middle.z);
    const Vec3 meridian = off_axis > 0.0 ? Vec3{0, middle.y, middle.z} / off_axis : Vec3{0, 1, 0}, radial{1, 0, 0};
    const Vec3 transverse = cross(radial, meridian);
    const double critical_cosine = family != nullptr ? family->critical_cosine() : -1.0;
    const double critical_sine = family != nullptr ? family->critical_sine() : 0.0;
    const auto polar = [&](Vec3 v) -> FrameVector {
        return {dot(v, meridian), dot(v, transverse), v.x, critical_sine * v.x - critical_cosine * dot(v, meridian)};
    };
    frame.polar_0 = polar(middle);
    frame.polar_0.y = 0.0;  // the middle is in the meridian
    frame.polar_x = polar(at_rest(right, 0.0));
    frame.polar_y = polar(at_rest(up, 0.0));
    if (plan.ring) {
        frame.polar_0.w = 0.0;  // the middle is on the critical curve
        frame.polar_length = polar(at_rest({}, 1.0));
        frame.polar_weight = {weight(ahead, 1.0), weight(right, 0.0), weight(up, 0.0), weight({}, 1.0)};
        frame.ring = {2.0 * M_PI * plan.ring->turns, plan.ring->lag, plan.ring->half_way, 0};
    }
    frame.radial = {world * radial, g_factor};
    frame.meridian = {world * meridian, 0};
    frame.transverse = {world * transverse, 0};
}

// What a zoom leaves of a star's peak: it is as bright as without the zoom, and none where a pixel is narrower than the digits of its place.
double star_share(const FramePlan& plan) {
    constexpr double kFinestPlace = 2e-6;  // rad
    if (!plan.ring) return 1.0;
    if (plan.scene.camera.pixel() < kFinestPlace) return 0.0;
    return std::exp(-2.0 * plan.ring->depth);
}

void put_sky(FrameData& frame, const FramePlan& plan, const TextureFacts& textures) {
    const int size = std::max(textures.sky_size, 1);
    frame.sky = {0.5 * size, sky_levels(size) - 1.0, textures.sky_light, 0};
    const double passed = plan.effects.contains(Effect::kPolariser) ? 0.5 : 1.0;
    frame.point_stars = {passed * star_share(plan) * point_peak(), 2.0 * kPointSigma_px * kPointSigma_px * M_LN2,
                         1.0 / kFaintestPoint, kPointMargin_px};
    frame.point_spread = {M_LOG2E / (2.0 * kPointSigma_px * kPointSigma_px), 0, 0, 0};
}

void put_disc(FrameData& frame, const FramePlan& plan, const TextureFacts& textures) {
    const Scene& scene = plan.scene;
    const DiscSpec disc = scene.disc.value_or(DiscSpec{});
    const DiscPlane plane = DiscShape(disc, scene.time).base();
    const Vec3 outward = world_from_static(scene.camera.theta, scene.camera.phi).a;
    frame.disc_normal = {plane.normal, height_over(plane, outward)};
    frame.disc_x = {plane.x, scene.disc ? disc.inner : 1e30};  // no disc: no radius is on it
    frame.disc_y = {plane.y, scene.disc ? disc.outer : 0.0};
    if (!scene.disc) return;
    frame.disc_map = {std::cos(disc.rotation) / (2 * disc.outer), std::sin(disc.rotation) / (2 * disc.outer),
                      textures.disc_width / (2 * disc.outer), std::log2(std::max(textures.disc_width, 1))};
    frame.disc_surface = {disc.opacity, disc.edge, disc.brightness, static_cast<double>(plan.passed)};
    if (disc.material.texture == TextureKind::kGas)
        frame.disc_gas = {disc.gas.contrast,
                          sign_of(sense_about(*plan.matter, disc.sense)) * disc.gas.winding / (2 * M_PI),
                          disc.rotation / (2 * M_PI), late_time(plan)};
    frame.disc_gas_colour = {disc.brightness * disc.material.colour, 0};
    const double hottest_K = textures.disc_temperature_K.value_or(disc.temperature_K);
    if (disc.emission == DiscEmission::kThermal)
        frame.disc_heat = {1.0 / disc.inner, kDiscFlowCells / std::log(disc.outer / disc.inner), std::log2(hottest_K),
                           log2_brightness(hottest_K, scene.light.bolometric)};
}

void put_polarisation(FrameData& frame, const FramePlan& plan) {
    const Scene& scene = plan.scene;
    if (!polarises(plan.effects)) return;
    const ScreenForm form = screen_form(*plan.light, scene.camera, plan.observer, scene.light.aberration);
    frame.screen_real = {form[0].real(), form[1].real(), form[2].real(), 0};
    frame.screen_imaginary = {form[0].imag(), form[1].imag(), form[2].imag(), 0};
    if (has_polarised_disc(scene)) {
        const Vec3 field = field_of(scene.disc->polarisation);
        frame.polarisation = {field.x, -field.z, field.y, polarised_fraction(scene.disc->polarisation).value_or(-1.0)};
    }
    const double axis = scene.picture.polariser.value_or(0.0);
    frame.polariser = {std::cos(2.0 * axis), std::sin(2.0 * axis), 0, 0};
}

}  // namespace

Vec3 direction_without_rounding(Vec3 v) {
    const double scale = length(v);
    return {without_rounding(v.x, scale), without_rounding(v.y, scale), without_rounding(v.z, scale)};
}

double plane_height(double theta) {
    const double height = std::cos(theta);
    return std::fabs(height) < kInPlane ? 0.0 : height;
}

FrameData frame_numbers(const FramePlan& plan, const LightPath& path, const TextureFacts& textures,
                        const BallPaths& balls) {
    const Scene& scene = plan.scene;
    const Spacetime &spacetime = *plan.light, &matter = *plan.matter;
    const Observer& observer = plan.observer;
    const CameraSpec& camera = scene.camera;
    const Mat3 world = world_from_static(camera.theta, camera.phi);
    // Where light goes straight its frame is at rest and A = 1. What g then lacks, or has too much without gravity's part, is a factor.
    const auto [axes, radial] = path.start(plan, world);
    // Switched off with observers at rest only.
    const double g_gravity = scene.light.gravity ? 1.0 / observer.frame.energy() : 1.0;
    const double g_factor = plan.straight() || !scene.light.gravity ? g_gravity * radial.energy() : 1.0;
    FrameData frame;
    put_view(frame, plan, axes, world, path.family(), g_factor);
    const auto horizon = spacetime.horizon_radius();
    const Fate lost = horizon && camera.r <= *horizon ? Fate::kNoSky : inner_fate(spacetime.inner_end());
    frame.shift = {radial.energy(), 1.0 / matter.areal_radius(camera.r), radial.infall(), static_cast<double>(lost)};
    const auto sky_K = scene.sky.temperature_K;
    const double speed = length(observer.velocity), stretch = std::sqrt((1.0 + speed) / (1.0 - speed));
    frame.boost = {speed > 0.0 ? axes * (observer.velocity / speed) : Vec3{1, 0, 0},
                   scene.light.aberration ? stretch : 1.0};
    frame.boost_colour = {scene.light.doppler ? stretch : 1.0,
                          sky_K ? log2_brightness(*sky_K, scene.light.bolometric) : 0.0, 0, 0};
    frame.sky_light = {1, 1, 1, 0};
    if (sky_K)
        frame.sky_light = {sky_light(scene.light, *sky_K, g_gravity, motion_is_seen(matter, observer, scene)),
                           std::log2(*sky_K)};
    put_sky(frame, plan, textures);
    put_disc(frame, plan, textures);
    put_polarisation(frame, plan);
    put_medium(frame, plan, textures.grid);
    frame.bloom = {scene.picture.bloom, 0, 0, 0};
    if (const auto& part = camera.part)
        frame.dither = {static_cast<double>(part->left), static_cast<double>(part->height - part->top - camera.height),
                        0, 0};
    put_march(frame, plan, balls);
    put_patterns(frame, scene);
    put_moving(frame, plan);
    path.write(plan, frame);
    return frame;
}

FrameData sample_numbers(const FramePlan& plan, const LightPath& path, const TextureFacts& textures,
                         const BallPaths& balls, int samples) {
    FramePlan fine = plan;
    CameraSpec& camera = fine.scene.camera;
    camera.width *= samples, camera.height *= samples;
    if (auto& part = camera.part)
        part->left *= samples, part->top *= samples, part->width *= samples, part->height *= samples;
    return frame_numbers(fine, path, textures, balls);
}

void put_samples(FrameData& frame, int samples, int first, int count, int fetches) {
    frame.sampling = {static_cast<double>(first), static_cast<double>(count), static_cast<double>(samples),
                      std::max(1.0, static_cast<double>(fetches) / samples)};
}

}  // namespace nullscope
