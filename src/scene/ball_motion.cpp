#include "scene/ball_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <array>
#include <memory>

#include "expr/formula.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

// In the plane of `outward` and `onward`.
BallPlace in_plane(Vec3 outward, Vec3 onward, double r, double phi, double r_dot, double phi_dot) {
    const Vec3 e = std::cos(phi) * outward + std::sin(phi) * onward, across = std::cos(phi) * onward - std::sin(phi) * outward;
    return {r * e, r_dot * e + (r * phi_dot) * across};
}

Vec3 eastward(Vec3 outward) {
    const double rho = std::hypot(outward.x, outward.y);
    return rho > 0.0 ? Vec3{-outward.y / rho, outward.x / rho, 0} : Vec3{0, 1, 0};
}

// Free fall in a plane: r'' = -(A (1 + L^2/r^2))'/2 by proper time, phi' = L/r^2, t' = E/A. Fourth order in steps that keep 1e-9.
class Fall {
public:
    static constexpr double kFrozen = 1e-3;   // of the horizon: nearer to it as good as still
    struct State {
        double t, r, r_tau, phi;
    };
    Fall(const Spacetime& spacetime, double r, double r_tau, double energy, double momentum)
        : spacetime_(spacetime), energy_(energy), momentum_(momentum), start_{0, r, r_tau, 0}, at_(start_) {
        horizon_ = spacetime.horizon_radius().value_or(0.0);
    }
    State at(double t) {
        const double sense = t >= 0.0 ? 1.0 : -1.0;
        if (sense * (t - at_.t) < 0.0 || sense * at_.t < 0.0) at_ = start_;
        while (sense * (t - at_.t) > 0.0) {
            if (at_.r <= horizon_ * (1.0 + kFrozen)) return {t, at_.r, 0, at_.phi};
            const double room = 0.1 * (at_.r - horizon_) / std::max(std::fabs(at_.r_tau), 1e-3);   // no stage of a step is inside
            const double rate = energy_ / spacetime_.lapse_squared(at_.r);
            const double step = std::min({room, 0.01 * at_.r / std::max(std::fabs(at_.r_tau) + std::fabs(momentum_) / at_.r, 0.3), std::fabs(t - at_.t) / rate * 1.0000001});
            at_ = advanced(at_, sense * step);
            if (std::fabs(t - at_.t) < 1e-7) break;
        }
        return at_;
    }
    BallPlace motion(double t, Vec3 outward, Vec3 onward) {
        const State s = at(t);
        const double rate = spacetime_.lapse_squared(s.r) / energy_;
        return in_plane(outward, onward, s.r + s.r_tau * rate * (t - s.t), s.phi, s.r_tau * rate, momentum_ / (s.r * s.r) * rate);
    }

private:
    State slope(const State& s) const {
        const double zeta = 1.0 / s.r, a = spacetime_.lapse_squared(s.r), half_slope = spacetime_.half_v_slope(zeta);
        const double a_r = -2.0 * (half_slope - zeta * a);   // dA/dr = -zeta^2 dA/dzeta
        const double l2 = momentum_ * momentum_;
        return {energy_ / a, s.r_tau, -0.5 * a_r * (1.0 + l2 * zeta * zeta) + a * l2 * zeta * zeta * zeta, momentum_ * zeta * zeta};
    }
    State advanced(const State& s, double h) const {
        const auto moved = [](const State& from, const State& by, double f) {
            return State{from.t + f * by.t, from.r + f * by.r, from.r_tau + f * by.r_tau, from.phi + f * by.phi};
        };
        const State k1 = slope(s), k2 = slope(moved(s, k1, 0.5 * h)), k3 = slope(moved(s, k2, 0.5 * h)), k4 = slope(moved(s, k3, h));
        State next = s;
        for (const auto& [k, weight] : {std::pair{k1, 1.0}, {k2, 2.0}, {k3, 2.0}, {k4, 1.0}}) next = moved(next, k, h * weight / 6.0);
        return next;
    }
    const Spacetime& spacetime_;
    double energy_, momentum_, horizon_;
    State start_, at_;
};

}  // namespace

Result<BallMotionAt> ball_motion(const Spacetime& spacetime, const BallSpec& ball) {
    const double r = length(ball.position);
    const Vec3 outward = ball.position / r, east = eastward(outward);
    if (ball.motion == BallMotion::kOrbit) {
        const auto orbit = circular_orbit(spacetime, r);
        if (!orbit) return bad_input(fmt::format("ball.position: no circular orbit at {} from the centre; allowed: outside the photon sphere", r));
        return BallMotionAt([=, omega = orbit->omega](double t) { return in_plane(outward, east, r, omega * t, 0, omega); });
    }
    if (ball.motion == BallMotion::kGeodesic) {
        if (!camera_can_rest(spacetime, r)) return bad_input(fmt::format("ball.position: nothing can be at rest at {} from the centre; allowed: {}", r, allowed_radii(spacetime)));
        const Vec3 v = ball.velocity, across = v.z * east + v.y * cross(east, outward);   // e_theta = e_phi x e_r
        const double speed = length(across), gamma = 1.0 / std::sqrt(1.0 - dot(v, v)), lapse = std::sqrt(spacetime.lapse_squared(r));
        auto fall = std::make_shared<Fall>(spacetime, r, gamma * v.x * lapse, gamma * lapse, gamma * speed * r);
        const Vec3 onward = speed > 0.0 ? across / speed : east;
        return BallMotionAt([=](double t) { return fall->motion(t, outward, onward); });
    }
    std::array<std::shared_ptr<expr::Formula>, 3> way;
    for (const auto& [i, text] : {std::pair{0, &ball.x}, {1, &ball.y}, {2, &ball.z}}) {
        auto parsed = expr::Formula::parse(*text, {"t"});
        if (!parsed) return parsed.error();
        way[static_cast<std::size_t>(i)] = std::make_shared<expr::Formula>(std::move(*parsed));
    }
    return BallMotionAt([=](double t) {
        const auto place = [&](double at) {
            const double values[] = {at};
            return Vec3{way[0]->value(values), way[1]->value(values), way[2]->value(values)};
        };
        const double h = 1e-4 * std::max(1.0, 1e-4 * std::fabs(t));
        return BallPlace{place(t), (place(t + h) - place(t - h)) / (2.0 * h)};
    });
}

}  // namespace nullscope
