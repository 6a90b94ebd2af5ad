// Letting go: the camera falls, on a clock that can be stopped, hurried and turned back. And the scene's own clock.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observer/observer.h"
#include "observer/spin_frame.h"
#include "plan/dump_window.h"
#include "plan/moving.h"
#include "scene/medium_dumps.h"
#include "spacetime/tortoise.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

// Takes hold of the camera again: at rest or on the circular orbit, where there is one.
bool hold(ViewState& view, ObserverKind observer, const Spacetime& spacetime) {
    CameraSpec held = view.scene.camera;
    held.observer = observer;
    held.velocity = {};
    // In an ergosphere nobody is at rest; without angular momentum one can stay there.
    if (observer == ObserverKind::kStatic && !spacetime.planar_rays() && !observer_of(spacetime, held))
        held.observer = ObserverKind::kZamo;
    if (const auto possible = observer_of(spacetime, held); !possible) {
        view.error = possible.error().message();
        return false;
    }
    if (falls(view.scene.camera)) view.scene.time -= time_ahead(spacetime, held.r);  // t again
    if (falls(view.scene.camera)) held.phi -= spacetime.azimuth_ahead(held.r);       // where the far sky has it
    view.scene.camera = held;
    view.fall.stop();
    return true;
}

std::string events(const Worldline& worldline, const NumberStyle& style) {
    std::string text = worldline.horizon_time()
                           ? fmt::format("Horizon crossed at {}. ", time_words(*worldline.horizon_time(), style))
                           : "";
    if (worldline.end() != WorldlineEnd::kOpen)
        text += fmt::format("The worldline ends at {}{}.", time_words(worldline.end_time(), style),
                            worldline.end() == WorldlineEnd::kSingularity ? ", in the singularity" : "");
    return text;
}

std::string rate_words(double rate, const NumberStyle& style) { return time_words(rate, style, 3) + " per second"; }

}  // namespace

Status release(ViewState& view) {
    TRY(gone, view.fall.let_go(view.scene));
    view.clock_runs = false;
    return Done{};
}

std::string end_of_fall(const ViewState& view) {
    const auto spacetime = spacetime_of(view.scene);
    const double r = view.scene.camera.r;
    std::string where;
    if (view.fall.line().end() == WorldlineEnd::kSingularity)
        where = " in the singularity";
    else if (spacetime != nullptr && r < spacetime->horizon_radius().value_or(0.0))
        where = fmt::format(" inside the hole at r = {}, as far in as light is traced",
                            length_words(r, style_in(view.scene, *spacetime, view.numbers), 4));
    else if (spacetime != nullptr && spacetime->surface_radius())
        where = " on the surface";
    return fmt::format("The fall has ended{}: R returns to the scene's camera", where);
}

bool fall_section(ViewState& view) {
    constexpr double kLongSlider = 1e4;  // r_s/c, of an orbit
    Fall& fall = view.fall;
    const auto spacetime = spacetime_of(view.scene);
    if (spacetime == nullptr) return false;
    bool changed = false;
    if (button_of_three(0,
                        fall.runs()     ? "Pause"
                        : fall.active() ? "Continue"
                                        : "Release",
                        "Release the camera: it falls freely from here with its present velocity. Its axes are "
                        "gyroscopes (parallel transport).")) {
        if (fall.active() && fall.tau() < fall.line().last())
            fall.run(!fall.runs());
        else if (const Status gone = release(view); !gone)
            view.error = gone.error().message();
    }
    if (button_of_three(1, "Hover", "At rest here, outside the horizon; in an ergosphere with zero angular momentum."))
        changed = hold(view, ObserverKind::kStatic, *spacetime);
    if (button_of_three(2, "Orbit",
                        "On the circular geodesic of this radius, outside the photon sphere; in free fall it stays "
                        "there."))
        changed = hold(view, ObserverKind::kOrbit, *spacetime);
    const NumberStyle style = style_in(view.scene, *spacetime, view.numbers);
    slide_as("Rate", fall.haste, 1e-2, 1e2, rate_words(fall.rate(), style),
             "Proper time of the camera per second of real time. A fall slows down as it comes near, and takes some 20 "
             "s from "
             "anywhere; drag to hurry it or to slow it down.",
             Scale::kLogarithmic);
    if (!fall.active()) return changed;
    double tau = fall.tau();
    const bool ends = fall.line().end() != WorldlineEnd::kOpen;
    if (slide_as("Proper time", tau, 0.0, ends ? fall.line().last() : std::min(fall.line().last(), kLongSlider),
                 time_words(tau, style), "Proper time since the camera was released. Drag to change it.")) {
        fall.run(false);
        fall.seek(view.scene, tau);
        changed = true;
    }
    if (tau >= fall.line().last()) paragraph("The fall has ended. Drag the proper time to go back, or press R.");
    if (const std::string text = events(fall.line(), style); !text.empty()) paragraph(text);
    return changed;
}

// The camera's own time beside it: of one at rest sqrt(A) of the clocks at infinity.
bool clock_section(ViewState& view) {
    constexpr double kSpan = 1e4;  // r_s/c that the slider covers
    Scene& scene = view.scene;
    if (!changes_with_time(scene)) {
        paragraph("Nothing in this scene changes with time.");
        return false;
    }
    if (button_of_three(0, view.clock_runs ? "Pause" : "Run", "Runs the scene's clock: t at the camera."))
        view.clock_runs = !view.clock_runs;
    double steps = 0.0;
    if (button_of_three(1, "Step back", "A tenth of a second at this rate.")) steps = -1.0;
    if (button_of_three(2, "Step", "A tenth of a second at this rate.")) steps = 1.0;
    scene.time += steps * kClockStep_s * view.clock_rate;
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return false;
    const NumberStyle style = style_in(scene, *spacetime, view.numbers);
    slide_as("Rate", view.clock_rate, 1e-2, 1e3, rate_words(view.clock_rate, style),
             "Scene time per second of real time.", Scale::kLogarithmic);
    const auto dumps = has_dumps(scene) ? std::optional(medium_times(*spacetime, scene)) : std::nullopt;
    bool changed = dumps ? slide_as("Time", scene.time, dumps->from, dumps->to, time_words(scene.time, style),
                                    "Drag to change the time, between the first and the last dump.")
                         : slide_as("Time", scene.time, 0.0, kSpan, time_words(scene.time, style),
                                    "Drag to change the time.", Scale::kLogarithmic);
    if (dumps) scene.time = std::clamp(scene.time, dumps->from, dumps->to);
    changed |= steps != 0.0;
    if (changed) view.clock_runs = false;
    changed |= tick("Delay", scene.light.delay,
                    "On: moving objects appear where they were when their light left. Off: where they are now.");
    if (scene.camera.observer == ObserverKind::kStatic && spacetime->lapse_squared(scene.camera.r) > 0.0)
        paragraph(fmt::format("Proper time of the camera: {}.",
                              time_words(std::sqrt(spacetime->lapse_squared(scene.camera.r)) * scene.time, style)));
    return changed;
}

bool step_clock(ViewState& view, double dt_s) {
    if (!view.clock_runs || view.fall.runs() || !changes_with_time(view.scene)) return false;
    view.scene.time += dt_s * view.clock_rate;
    if (!has_dumps(view.scene)) return true;
    const auto [from, to] = medium_times(view.scene);  // over and over
    if (view.scene.time > to) view.scene.time = from;
    return true;
}

}  // namespace nullscope::viewer
