// Features of the path that light takes, and the frequency that it arrives with.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "observer/spin_forms.h"
#include "observer/spin_ring.h"
#include "plan/feature.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/projection.h"
#include "spacetime/axial_metric.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

void hole(Scene& s) { s.spacetime.metric = "schwarzschild"; }

// Straight light knows one side of a wormhole.
void forget_sides(Scene& s) { s.bodies.clear(); }

std::string metric_words(const FrameFacts& f) {
    return fmt::format("spacetime.metric = \"{}\"", f.scene.spacetime.metric);
}
std::string observer_words(const FrameFacts& f) {
    return fmt::format("camera.observer = \"{}\"", observer_name(f.scene.camera.observer));
}

bool rotates(const FrameFacts& f) { return f.spacetime != nullptr && !f.planar; }
bool rays_end(const FrameFacts& f, InnerEnd end) { return f.bends() && f.spacetime->inner_end() == end; }
Reason heat_if(const FrameFacts& f, bool changed) {
    return f.heat != nullptr && f.has_g() && changed ? Reason(f.heat) : kNot;
}

}  // namespace

std::span<const Feature> light_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kLensing, "lensing", "EFFECT_LENSING", "Light follows the null geodesics of the metric.",
          "spacetime.metric is one that bends light and does not rotate, and light.lensing is not \"off\"",
          "one fetch and two linear interpolations a pixel"},
         [](const FrameFacts& f) { return reason_if(f.bends(), metric_words(f)); },
         [](Scene& s) {
             const auto metric = make_spacetime(s.spacetime.metric, s.spacetime.parameters);
             if (metric && (*metric)->by_proper_length()) forget_sides(s);
             // Straight light is that of an observer at rest, and not among matter: else all is put into flat space.
             s.light.lensing = falls(s.camera) || s.medium;
             if (s.light.lensing) s.spacetime = {"minkowski", {}};
             s.camera.zoom.reset();
         },
         nothing,
         hole},
        {{Effect::kSpin, "spin", "EFFECT_SPIN", "Light follows the null geodesics of a rotating hole.",
          "spacetime.metric is kerr or kerr-newman, and spin is above 0",
          "some 8 steps of five force evaluations per pixel, at most 64"},
         [](const FrameFacts& f) -> Reason {
             if (!rotates(f)) return kNot;
             return fmt::format("spacetime.spin = {}", 2.0 * f.spacetime->a());
         },
         [](Scene& s) {
             s.spacetime.parameters["spin"] = 0.0;
             if (s.medium && s.medium->kind == MediumKind::kGrid) s.medium.reset();  // its file is of one spin
         },
         nothing,
         [](Scene& s) { s.spacetime.metric = "kerr"; }},
        {{Effect::kSpinFall, "spin-fall", "EFFECT_SPIN_FALL",
          "Rays cross the horizon of a rotating hole to a camera that falls.",
          "the hole rotates, and camera.observer is \"rain\", \"fall\" or \"throw\"", "a square root a force"},
         [](const FrameFacts& f) { return reason_if(rotates(f) && falls(f.scene.camera), observer_words(f)); },
         nullptr,
         [](Scene& s) { s.spacetime.metric = "kerr"; },
         [](Scene& s) { s.camera.observer = ObserverKind::kRain; }},
        {{Effect::kAberration, "aberration", "EFFECT_ABERRATION",
          "Directions and frequencies are those of a camera that moves in its observer's frame.",
          "camera.velocity is not zero, or camera.observer is \"orbit\", and light.aberration or light.doppler is not "
          "\"off\"",
          "one division a pixel"},
         [](const FrameFacts& f) -> Reason {
             if (!f.moves) return kNot;
             const LightSpec& light = f.scene.light;
             const Vec3 v = f.scene.camera.velocity;
             const char* part = !light.aberration ? ", light.aberration = \"off\": frequencies alone"
                                : !light.doppler  ? ", light.doppler = \"off\": directions alone"
                                                  : "";
             return (f.scene.camera.observer != ObserverKind::kStatic && v == Vec3{}
                         ? observer_words(f)
                         : fmt::format("camera.velocity = [{}, {}, {}]", v.x, v.y, v.z)) +
                    part;
         },
         [](Scene& s) {
             s.camera.velocity = {0, 0, 0};
             if (s.camera.observer == ObserverKind::kOrbit || s.camera.observer == ObserverKind::kCounterOrbit ||
                 s.spacetime.metric == "minkowski")
                 s.camera.observer = ObserverKind::kStatic;
         },
         nothing,
         [](Scene& s) {
             s.camera.velocity = {0.1, 0.2, 0.3};
         }},
        {{Effect::kZoom, "zoom", "EFFECT_ZOOM", "Directions are relative to the critical curve, at any depth.",
          "there is a [zoom], and light is bent", "for moving cameras two more vectors of a few multiplications"},
         [](const FrameFacts& f) -> Reason {
             if (!(f.bends() || rotates(f)) || !f.scene.camera.zoom) return kNot;
             return fmt::format("zoom.depth = {}", f.scene.camera.zoom->depth);
         },
         [](Scene& s) { s.camera.zoom.reset(); },
         hole,
         [](Scene& s) { s.camera.zoom.emplace(); }},
        {{Effect::kSpinRing, "spin-ring", "EFFECT_SPIN_RING",
          "Rays next to the critical curve of a rotating hole keep their distance from it to full precision.",
          "the hole rotates and the view is next to its critical curve, so narrow that the curve would be over 2700 px "
          "wide, or there is a [zoom]",
          "steps of a tenth more work, at most 512"},
         [](const FrameFacts& f) -> Reason {
             if (!rotates(f) || f.observer == nullptr) return kNot;
             const CameraSpec& camera = f.scene.camera;
             if (camera.zoom) return fmt::format("zoom.depth = {}", camera.zoom->depth);
             return reason_if(is_next_to_ring(*f.spacetime, camera, *f.observer, f.scene.light),
                              fmt::format("camera.fov = {:.3g}", 180.0 / M_PI * field_of_view(camera)));
         },
         nullptr,
         [](Scene& s) { s.spacetime.metric = "kerr"; },
         [](Scene& s) { s.camera.plane_width = 0.01, s.camera.yaw = -0.17; }},
        {{Effect::kSpinNear, "spin-near", "EFFECT_SPIN_NEAR",
          "Rays next to the horizon of a rotating hole keep their distance from it to full precision.",
          "the hole rotates, and 1 - r_+/camera.r is between -0.6 and 0.6", "steps of a tenth more work"},
         [](const FrameFacts& f) {
             return reason_if(rotates(f) && is_next_to_horizon(*f.spacetime, f.scene.camera.r),
                              fmt::format("camera.r = {:.4g}", f.scene.camera.r));
         },
         nullptr,
         [](Scene& s) { s.spacetime.metric = "kerr"; },
         [](Scene& s) { s.camera.observer = ObserverKind::kZamo, s.camera.r = 0.8; }},
        {{Effect::kShift, "shift", "EFFECT_SHIFT", "Doppler and gravitational shift change the colour of light.",
          "something emits thermal light, light.shift is not \"off\", nor are both light.doppler and light.gravity",
          "one logarithm a crossing or star"},
         [](const FrameFacts& f) { return heat_if(f, f.scene.light.shift); },
         [](Scene& s) { s.light.shift = false; },
         glowing<false, false>,
         glowing<true, false>},
        {{Effect::kBeaming, "beaming", "EFFECT_BEAMING",
          "Doppler and gravitational shift change the brightness of light.",
          "something emits thermal light, light.beaming is not \"off\", nor are both light.doppler and light.gravity",
          "one logarithm a crossing or star"},
         [](const FrameFacts& f) { return heat_if(f, f.scene.light.beaming); },
         [](Scene& s) { s.light.beaming = false; },
         glowing<false, false>,
         glowing<false, true>},
        {{Effect::kBolometric, "bolometric", "EFFECT_BOLOMETRIC", "Brightness is power at all wavelengths.",
          "something emits thermal light and light.band is \"bolometric\"", "nothing"},
         [](const FrameFacts& f) {
             return reason_if(f.heat != nullptr && f.scene.light.bolometric, "light.band = \"bolometric\"");
         },
         [](Scene& s) { s.light.bolometric = false; },
         glowing<true, true>,
         [](Scene& s) { s.light.bolometric = true; }},
        {{Effect::kInner, "inner", "EFFECT_INNER", "Rays inside the critical direction end on something visible.",
          "spacetime.metric is a wormhole, a star or a charge without horizon", "more octaves of the strip"},
         [](const FrameFacts& f) { return reason_if(f.bends() && !rays_end(f, InnerEnd::kHorizon), metric_words(f)); },
         nullptr,
         hole,
         dark_wormhole},
        {{Effect::kBounce, "bounce", "EFFECT_BOUNCE",
          "Rays inside the critical direction turn and return to the same sky.",
          "spacetime.metric is a charge without horizon", "more octaves of the strip, about the centre"},
         [](const FrameFacts& f) {
             return reason_if(rays_end(f, InnerEnd::kSameSky), metric_words(f) + " without horizon");
         },
         nullptr,
         hole,
         [](Scene& s) {
             s.spacetime = {"reissner-nordstrom", {{"charge", 1.2}}};
         }},
        {{Effect::kStar, "star", "EFFECT_STAR", "Rays end on the surface of a star.", "spacetime.metric is a star",
          "arithmetic where the star is seen"},
         [](const FrameFacts& f) { return reason_if(rays_end(f, InnerEnd::kSurface), metric_words(f)); },
         nullptr,
         hole,
         [](Scene& s) { s.spacetime.metric = "neutron-star"; }},
        {{Effect::kSides, "sides", "EFFECT_SIDES", "Bodies stand on either side of a wormhole's throat.",
          "spacetime.metric is a wormhole and there is a body", "a logarithm and a root a step"},
         [](const FrameFacts& f) {
             const bool wormhole = f.bends() && f.spacetime->by_proper_length();
             return reason_if(wormhole && has_marched(f.so_far), metric_words(f));
         },
         forget_sides,
         dark_wormhole,
         [](Scene& s) { add<BallSpec>(s); }},
        {{Effect::kDelay, "delay", "EFFECT_DELAY",
          "Light-travel time: moving objects appear where they were when their light left.",
          "something changes with time and light.delay is not \"off\"",
          "four fetches and a logarithm per crossing or sample of a body; about a rotating hole a square root per "
          "force"},
         [](const FrameFacts& f) -> Reason {
             const std::string moving = moving_words(f.scene);
             return reason_if(!moving.empty() && f.scene.light.delay, moving);
         },
         [](Scene& s) { s.light.delay = false; },
         moving_disc,
         [](Scene& s) { s.light.delay = true; }},
        {{Effect::kLightTimes, "light-times", "EFFECT_LIGHT_TIMES", "Light-travel times along rays are computed.",
          "the effect delay, or output of ray data or layers", "that of delay; none in pictures without it"},
         [](const FrameFacts& f) { return reason_if(f.so_far.contains(Effect::kDelay), "the effect delay"); },
         nullptr,
         moving_disc,
         [](Scene& s) { s.light.delay = true; }},
        {{Effect::kInnerHorizon, "inner-horizon", "EFFECT_INNER_HORIZON",
          "Light-travel time about a hole with an inner horizon.",
          "light-travel time is needed about a hole with spacetime.charge",
          "a logarithm per crossing or sample of a body"},
         [](const FrameFacts& f) {
             const bool late = f.bends() && f.so_far.contains(Effect::kLightTimes);
             return reason_if(late && f.spacetime->spherical()->has_inner_root(), metric_words(f));
         },
         nullptr,
         [](Scene& s) { moving_disc(s), s.light.delay = true; },
         [](Scene& s) {
             s.spacetime = {"reissner-nordstrom", {{"charge", 0.8}}};
         }},
    });
    return features;
}

}  // namespace nullscope
