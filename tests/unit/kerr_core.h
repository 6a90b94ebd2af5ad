// One ray about a rotating hole through the shader core, and how far its answers move when its direction does.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "observer/pose.h"
#include "observer/spin_forms.h"
#include "reference/kerr_ray.h"
#include "shadercore/core_trace.h"
#include "support/metrics.h"

namespace nullscope::test {

struct KerrView {
    double r, theta;
    Vec3 direction;  // unit, along (e_r, e_theta, e_phi) of the camera at rest, or of the one that moves
};

// rims: of an opaque disc.
inline RayPixel kerr_core(double spin, const KerrView& view, bool in_float,
                          std::optional<std::array<double, 2>> rims = {}, Vec3 velocity = {0, 0, 0}) {
    const auto spacetime = kerr(spin);
    const SpinPlace place = spin_place(*spacetime, view.r, view.theta);
    const SpinForms f = spin_forms(place, zamo_frame(place));
    CoreInput input;
    FrameData& frame = input.frame;
    const double a = spacetime->a(), outer = spacetime->outer_horizon(), cosine = std::cos(view.theta),
                 speed = length(velocity);
    frame.image = {1, 1, 1e-6, 1};
    frame.ray_0 = {view.direction.x, view.direction.y, view.direction.z, 0};
    frame.shift = {1, 1 / view.r, 0, 1};
    if (speed > 0)
        frame.boost = {velocity.x / speed, velocity.y / speed, velocity.z / speed,
                       std::sqrt((1 + speed) / (1 - speed))};
    frame.boost_colour = {std::sqrt((1 + speed) / (1 - speed)), 0, 0, 0};
    frame.disc_x = {1, 0, 0, rims ? (*rims)[0] : 1e30};
    frame.disc_y = {0, 1, 0, rims ? (*rims)[1] : 0};
    frame.disc_surface = {1, 0, 1, 0};
    frame.spin_hole = {a, a * a, outer, a * a / outer};
    frame.spin_energy = {f.energy.constant, f.energy.radial, f.energy.around, f.p_theta};
    frame.spin_across = {f.across.constant, f.across.radial, f.across.around, f.carter};
    frame.spin_climb = {f.climb.constant, f.climb.radial, f.climb.around, f.carter_slope};
    frame.spin_place = {std::sin(view.theta), std::fabs(cosine) < 1e-12 ? 0.0 : cosine, 1, 0};
    frame.spin_turn = {spacetime->azimuth_ahead(view.r), a / (outer - spacetime->inner_horizon()), spacetime->charge2(),
                       outer - spacetime->inner_horizon()};
    input.lensing = false, input.spin = true, input.aberration = speed > 0;
    return in_float ? trace_core32(input, 0, 0) : trace_core64(input, 0, 0);
}

inline reference::KerrRay kerr_exact(double spin, const KerrView& view, Vec3 nudge = {0, 0, 0}) {
    return reference::trace_kerr(spin, {view.r, view.theta, 0, normalized(view.direction + nudge)}, 2);
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
