// One ray about a spinning hole through the shader core, and how far its answers move when its direction does.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "camera/pose.h"
#include "camera/spin_forms.h"
#include "reference/kerr_ray.h"
#include "shadercore/core_trace.h"
#include "spacetime/registry.h"

namespace nullscope::test {

struct KerrView {
    double r, theta;
    Vec3 look;  // unit, along (e_r, e_theta, e_phi) of the camera at rest, or of the one that moves
};

// Members of FrameData (shaders/shared/frame_block.glsl), by number.
enum Member {
    kImage = 0,
    kRay0 = 1,
    kShift = 10,
    kBoost = 14,
    kBoostColour = 15,
    kDiscX = 19,
    kDiscY = 20,
    kDiscLook = 22,
    kSpinHole = 60,
    kSpinEnergy,
    kSpinAcross,
    kSpinClimb,
    kSpinPlace,
    kSpinTurn
};

// rims: of an opaque disc.
inline RayPixel kerr_core(double spin, const KerrView& view, bool in_float,
                          std::optional<std::array<double, 2>> rims = {}, Vec3 velocity = {0, 0, 0}) {
    const auto spacetime = *make_spacetime("kerr", {{"spin", spin}});
    const SpinPlace place = spin_place(*spacetime, view.r, view.theta);
    const SpinForms f = spin_forms(place, zamo_frame(place));
    CoreInput input;
    const auto put = [&](Member member, double x, double y, double z, double w) {
        const std::array<double, 4> numbers{x, y, z, w};
        std::copy(numbers.begin(), numbers.end(), input.frame.begin() + 4 * member);
    };
    const double a = spacetime->spin(), outer = *spacetime->horizon_radius(), cosine = std::cos(view.theta),
                 speed = length(velocity);
    put(kImage, 1, 1, 1e-6, 1);
    put(kRay0, view.look.x, view.look.y, view.look.z, 0);
    put(kShift, 1, 1 / view.r, 0, 1);
    if (speed > 0)
        put(kBoost, velocity.x / speed, velocity.y / speed, velocity.z / speed, std::sqrt((1 + speed) / (1 - speed)));
    put(kBoostColour, std::sqrt((1 + speed) / (1 - speed)), 0, 0, 0);
    put(kDiscX, 1, 0, 0, rims ? (*rims)[0] : 1e30);
    put(kDiscY, 0, 1, 0, rims ? (*rims)[1] : 0);
    put(kDiscLook, 1, 0, 1, 0);
    put(kSpinHole, a, a * a, outer, a * a / outer);
    put(kSpinEnergy, f.energy.constant, f.energy.radial, f.energy.around, f.p_theta);
    put(kSpinAcross, f.across.constant, f.across.radial, f.across.around, f.carter);
    put(kSpinClimb, f.climb.constant, f.climb.radial, f.climb.around, f.carter_slope);
    put(kSpinPlace, std::sin(view.theta), std::fabs(cosine) < 1e-12 ? 0.0 : cosine, 1, 0);
    put(kSpinTurn, azimuth_ahead(*spacetime, view.r), a / (outer - inner_horizon(*spacetime)), 0, 0);
    input.lensing = false, input.spin = true, input.aberration = speed > 0;
    return in_float ? trace_core32(input, 0, 0) : trace_core64(input, 0, 0);
}

inline reference::KerrRay kerr_exact(double spin, const KerrView& view, Vec3 nudge = {0, 0, 0}) {
    return reference::trace_kerr(spin, {view.r, view.theta, 0, normalized(view.look + nudge)}, 2);
}

// How fast an answer moves with the direction, rad or r_s per rad: the larger of three nudges, at least `least`.
template <class Distance>
double kerr_sway(double spin, const KerrView& view, double least, Distance distance) {
    constexpr double kNudge = 1e-7;
    const reference::KerrRay here = kerr_exact(spin, view);
    double most = least;
    for (const Vec3 nudge : {Vec3{kNudge, 0, 0}, Vec3{0, kNudge, 0}, Vec3{0, 0, kNudge}}) {
        const double moved = distance(here, kerr_exact(spin, view, nudge)) / kNudge;
        if (std::isfinite(moved)) most = std::max(most, moved);
    }
    return most;
}

inline double kerr_sky_sway(double spin, const KerrView& view) {
    return kerr_sway(spin, view, 1.0, [](const auto& a, const auto& b) { return length(a.sky - b.sky); });
}

// Of crossing k; at least the distance from the camera to the hole, as pixels see it.
inline double kerr_place_sway(double spin, const KerrView& view, int k) {
    return kerr_sway(spin, view, view.r, [k](const reference::KerrRay& a, const reference::KerrRay& b) {
        const auto i = static_cast<std::size_t>(k - 1);
        if (a.crossings.size() <= i || b.crossings.size() <= i) return kNotANumber;
        const auto &p = a.crossings[i], &q = b.crossings[i];
        return std::hypot(p.r * std::cos(p.phi) - q.r * std::cos(q.phi), p.r * std::sin(p.phi) - q.r * std::sin(q.phi));
    });
}

// Does a nudge of the direction by `angle` change whether the ray is captured?
inline bool kerr_edge_within(double spin, const KerrView& view, double angle) {
    const Fate here = kerr_exact(spin, view).fate;
    for (const double h : {angle, -angle})
        for (const Vec3 nudge : {Vec3{h, 0, 0}, Vec3{0, h, 0}, Vec3{0, 0, h}})
            if (kerr_exact(spin, view, nudge).fate != here) return true;
    return false;
}

}  // namespace nullscope::test
