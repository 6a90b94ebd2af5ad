#include "reference/ball_way.h"

#include <array>
#include <cmath>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "expr/formula.h"

namespace nullscope::reference {
namespace {

using State = std::array<double, 3>;   // r, phi, p_r

double lapse2(const OrbitMetric& metric, double r) {
    const double lapse = metric.lapse(r);
    return lapse * lapse;
}

double slope_of(const OrbitMetric& metric, double r) {   // of A; eighth order
    const double h = 0.01 * r;
    const auto d = [&](int n) { return lapse2(metric, r + n * h) - lapse2(metric, r - n * h); };
    return (d(1) * 4.0 / 5 - d(2) / 5 + d(3) * 4.0 / 105 - d(4) / 280) / h;
}

// H = sqrt(A (1 + A p_r^2 + L^2/r^2)) = E.
State at_time(const OrbitMetric& metric, State start, double momentum, double t) {
    const auto flow = [&](const State& s, State& by, double) {
        const double r = s[0], a = lapse2(metric, r), l2 = momentum * momentum / (r * r), inner = 1 + a * s[2] * s[2] + l2, h = std::sqrt(a * inner);
        const double a_r = slope_of(metric, r);
        by = {a * a * s[2] / h, a * momentum / (r * r * h), -(a_r * inner + a * (a_r * s[2] * s[2] - 2 * l2 / r)) / (2 * h)};
    };
    namespace odeint = boost::numeric::odeint;
    if (t != 0) odeint::integrate_adaptive(odeint::make_controlled(1e-11, 1e-11, odeint::runge_kutta_fehlberg78<State>()), flow, start, 0.0, t, t > 0 ? 0.1 : -0.1);
    return start;
}

}  // namespace

double kepler_rate(const OrbitMetric& metric, double r) { return std::sqrt(std::fmax(slope_of(metric, r), 0) / (2 * r)); }

std::function<Vec3(double t)> ball_way(const OrbitMetric& metric, const BallSpec& ball) {
    const Vec3 start = ball.position;
    const double r = length(start), theta = std::acos(start.z / r), azimuth = std::atan2(start.y, start.x);
    const Vec3 e_r = start / r, e_theta{std::cos(theta) * std::cos(azimuth), std::cos(theta) * std::sin(azimuth), -std::sin(theta)},
               e_phi{-std::sin(azimuth), std::cos(azimuth), 0};
    const auto turned = [=](Vec3 onward, double radius, double phi) { return radius * (std::cos(phi) * e_r + std::sin(phi) * onward); };
    switch (ball.motion) {
        case BallMotion::kStill: break;
        case BallMotion::kOrbit: return [=, omega = kepler_rate(metric, r)](double t) { return turned(e_phi, r, omega * t); };
        case BallMotion::kGeodesic: {
            const Vec3 v = ball.velocity, across = v.y * e_theta + v.z * e_phi;
            const double speed = length(across), gamma = 1 / std::sqrt(1 - dot(v, v)), lapse = metric.lapse(r);
            const State first{r, 0, gamma * v.x / lapse};
            return [=, &metric, onward = speed > 0 ? across / speed : e_phi](double t) {
                const State s = at_time(metric, first, gamma * speed * r, t);
                return turned(onward, s[0], s[1]);
            };
        }
        case BallMotion::kPath: {
            const auto x = expr::Formula::parse(ball.x, {"t"}), y = expr::Formula::parse(ball.y, {"t"}), z = expr::Formula::parse(ball.z, {"t"});
            if (!x || !y || !z) break;
            return [x = *x, y = *y, z = *z](double t) {
                const double at[] = {t};
                return Vec3{x.value(at), y.value(at), z.value(at)};
            };
        }
    }
    return [start](double) { return start; };
}

}  // namespace nullscope::reference
