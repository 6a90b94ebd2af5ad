// Features of the path that light takes, and the frequency that it arrives with.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/feature.h"
#include "scene/moving.h"
#include "spacetime/axial_metric.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

void hole(Scene& s) { s.spacetime.metric = "schwarzschild"; }

// Straight light knows one side of a wormhole.
void forget_sides(Scene& s) { s.cylinder.reset(), s.ball.reset(), s.surface.reset(); }

std::string metric_of(const FrameFacts& f) {
    return fmt::format("spacetime.metric = \"{}\"", f.scene.spacetime.metric);
}

}  // namespace

std::span<const Feature> light_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kLensing, "lensing", "EFFECT_LENSING", "Light follows the null geodesics of the metric.",
          "spacetime.metric is one that bends light and does not rotate, and light.lensing is not \"off\"",
          "deflection table, strip; one fetch and two straight lines a pixel"},
         [](const FrameFacts& f) -> Reason {
             return !f.planar || !f.spacetime->bends_light() || !f.scene.light.lensing ? kNot : Reason(metric_of(f));
         },
         [](Scene& s) {
             const auto metric = make_spacetime(s.spacetime.metric, s.spacetime.parameters);
             if (metric && (*metric)->by_proper_length()) forget_sides(s);
             // Straight light is that of an observer at rest: what falls is put into flat space.
             s.light.lensing = falls(s.camera);
             if (s.light.lensing) s.spacetime = {"minkowski", {}};
         },
         nothing,
         hole},
        {{Effect::kSpin, "spin", "EFFECT_SPIN", "Light follows the null geodesics of a rotating hole.",
          "spacetime.metric is kerr or kerr-newman, and spin is above 0",
          "some 8 steps of five forces a pixel, at most 64"},
         [](const FrameFacts& f) -> Reason {
             return f.spacetime == nullptr || f.planar
                        ? kNot
                        : Reason(fmt::format("spacetime.spin = {}", 2.0 * f.spacetime->axial()->a()));
         },
         [](Scene& s) { s.spacetime.parameters["spin"] = 0.0; },
         nothing,
         [](Scene& s) { s.spacetime.metric = "kerr"; }},
        {{Effect::kSpinFall, "spin-fall", "EFFECT_SPIN_FALL",
          "Rays cross the horizon of a rotating hole to a camera that falls.",
          "the hole rotates, and camera.observer is \"rain\", \"fall\" or \"throw\"", "a square root a force"},
         [](const FrameFacts& f) -> Reason {
             return f.spacetime == nullptr || f.planar || !falls(f.scene.camera)
                        ? kNot
                        : Reason(fmt::format("camera.observer = \"{}\"", observer_name(f.scene.camera.observer)));
         },
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
             const CameraSpec& camera = f.scene.camera;
             const Vec3 v = camera.velocity;
             const char* part = !light.aberration ? ", light.aberration = \"off\": frequencies alone"
                                : !light.doppler  ? ", light.doppler = \"off\": directions alone"
                                                  : "";
             return (camera.observer != ObserverKind::kStatic && v == Vec3{}
                         ? fmt::format("camera.observer = \"{}\"", observer_name(camera.observer))
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
        {{Effect::kShift, "shift", "EFFECT_SHIFT", "Light has the colour that motion and gravity give it.",
          "something shines by its heat, light.shift is not \"off\", nor are both light.doppler and light.gravity",
          "one logarithm a crossing or star"},
         [](const FrameFacts& f) -> Reason {
             return f.heat != nullptr && f.has_g() && f.scene.light.shift ? Reason(f.heat) : kNot;
         },
         [](Scene& s) { s.light.shift = false; },
         glowing<false, false>,
         glowing<true, false>},
        {{Effect::kBeaming, "beaming", "EFFECT_BEAMING", "Light has the brightness that motion and gravity give it.",
          "something shines by its heat, light.beaming is not \"off\", nor are both light.doppler and light.gravity",
          "one logarithm a crossing or star"},
         [](const FrameFacts& f) -> Reason {
             return f.heat != nullptr && f.has_g() && f.scene.light.beaming ? Reason(f.heat) : kNot;
         },
         [](Scene& s) { s.light.beaming = false; },
         glowing<false, false>,
         glowing<false, true>},
        {{Effect::kBolometric, "bolometric", "EFFECT_BOLOMETRIC", "Brightness is power at all wavelengths.",
          "something shines by its heat and light.band is \"bolometric\"", "nothing"},
         [](const FrameFacts& f) -> Reason {
             return f.heat != nullptr && f.scene.light.bolometric ? Reason("light.band = \"bolometric\"") : kNot;
         },
         [](Scene& s) { s.light.bolometric = false; },
         glowing<true, true>,
         [](Scene& s) { s.light.bolometric = true; }},
        {{Effect::kInner, "inner", "EFFECT_INNER", "Rays that pass the critical direction inward end somewhere to see.",
          "spacetime.metric is a wormhole, a star or a charge without horizon", "more octaves of the strip"},
         [](const FrameFacts& f) -> Reason {
             return !f.bends() || f.spacetime->inner_end() == InnerEnd::kHorizon ? kNot : Reason(metric_of(f));
         },
         nullptr,
         hole,
         dark_wormhole},
        {{Effect::kBounce, "bounce", "EFFECT_BOUNCE",
          "Rays that pass the critical direction inward turn and come back to the same sky.",
          "spacetime.metric is a charge without horizon", "more octaves of the strip, about the centre"},
         [](const FrameFacts& f) -> Reason {
             return !f.bends() || f.spacetime->inner_end() != InnerEnd::kSameSky
                        ? kNot
                        : Reason(metric_of(f) + " without horizon");
         },
         nullptr,
         hole,
         [](Scene& s) {
             s.spacetime = {"reissner-nordstrom", {{"charge", 1.2}}};
         }},
        {{Effect::kStar, "star", "EFFECT_STAR", "Rays end on the surface of a star.", "spacetime.metric is a star",
          "arithmetic where the star is seen"},
         [](const FrameFacts& f) -> Reason {
             return !f.bends() || f.spacetime->inner_end() != InnerEnd::kSurface ? kNot : Reason(metric_of(f));
         },
         nullptr,
         hole,
         [](Scene& s) { s.spacetime.metric = "neutron-star"; }},
        {{Effect::kSides, "sides", "EFFECT_SIDES", "Bodies stand on either side of a wormhole's throat.",
          "spacetime.metric is a wormhole and there is a body", "a logarithm and a root a step"},
         [](const FrameFacts& f) -> Reason {
             return !f.bends() || !f.spacetime->by_proper_length() || !has_marched(f.so_far) ? kNot
                                                                                             : Reason(metric_of(f));
         },
         [](Scene& s) { forget_sides(s); },
         dark_wormhole,
         [](Scene& s) { s.ball.emplace(); }},
        {{Effect::kDelay, "delay", "EFFECT_DELAY",
          "Light takes time: what moves is seen where it was when its light left.",
          "something changes with time and light.delay is not \"off\"",
          "delay map; four fetches and a logarithm a crossing or a look at a body; about a rotating hole a root a "
          "force"},
         [](const FrameFacts& f) -> Reason {
             const auto moving = moving_parts(f.scene);
             if (moving.empty() || !f.scene.light.delay) return kNot;
             return fmt::format("{}", fmt::join(moving, ", "));
         },
         [](Scene& s) { s.light.delay = false; },
         moving_disc,
         [](Scene& s) { s.light.delay = true; }},
        {{Effect::kInnerHorizon, "inner-horizon", "EFFECT_INNER_HORIZON",
          "The time that light takes is that of a hole with an inner horizon.",
          "light takes time about a hole with spacetime.charge", "a logarithm a crossing or a look at a body"},
         [](const FrameFacts& f) -> Reason {
             return !f.bends() || !f.so_far.contains(Effect::kDelay) || !f.spacetime->spherical()->has_inner_horizon()
                        ? kNot
                        : Reason(metric_of(f));
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
