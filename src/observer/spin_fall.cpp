#include "observer/spin_fall.h"

#include <algorithm>
#include <cmath>

#include "numeric/dormand_prince.h"

namespace nullscope {
namespace {

constexpr double kFallFrozen = 1e-6;  // of the horizon: nearer to it as good as still
constexpr double kFallStep = 1e-12;   // error of a step: r_s, rad
constexpr double kFallFirst = 1e-2;   // r_s/c
constexpr double kOnAxis = 1e-12;     // of sin(theta): then there is no momentum about the axis

}  // namespace

// At rest u^t = 1/sqrt(-g_tt); e_phi is d/dphi - (g_tphi/g_tt) d/dt over its length, to which u_t does not belong.
SpinFall::SpinFall(const AxialMetric& metric, const Start& start)
    : metric_(metric), outer_(metric.outer_horizon()), length_(kFallFirst) {
    const double r = start.r, a = metric.a(), sine = std::sin(start.theta), cosine = std::cos(start.theta);
    const double sigma = r * r + a * a * cosine * cosine, delta = metric.delta(r),
                 pull = metric.two_mass(r) * r / sigma, rest = std::sqrt(1.0 - pull),
                 gamma = 1.0 / std::sqrt(1.0 - dot(start.velocity, start.velocity));
    energy_ = gamma * rest;
    momentum_ =
        std::fabs(sine) > kOnAxis ? gamma * sine * (start.velocity.z * std::sqrt(delta) - pull * a * sine) / rest : 0.0;
    const double turn = gamma * start.velocity.y * std::sqrt(sigma),
                 across = std::fabs(sine) > kOnAxis ? a * energy_ * sine - momentum_ / sine : 0.0;
    carter_ = turn * turn + a * a * cosine * cosine + across * across;
    start_ = {r, gamma * start.velocity.x * std::sqrt(sigma * delta), start.theta, turn, 0.0};
    at_ = start_;
}

SpinFall::State SpinFall::slope(const State& s) const {
    const double r = s[0], w = s[1], theta = s[2], u = s[3], a = metric_.a(), delta = metric_.delta(r),
                 x = energy_ * (r * r + a * a) - a * momentum_;
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const double round = momentum_ != 0.0 ? momentum_ / sine : 0.0, over = momentum_ != 0.0 ? round / sine : 0.0;
    const double outward = 2.0 * r * energy_ * x - 0.5 * (2.0 * r - 1.0) * (r * r + carter_) - delta * r;
    const double southward = cosine * (a * a * sine - (a * energy_ * sine - round) * (a * energy_ + over));
    // Rates by lambda times Delta over dt/dlambda times Delta.
    const double time = (r * r + a * a) * x + delta * a * (momentum_ - a * energy_ * sine * sine), by = delta / time;
    return {w * by, outward * by, u * by, southward * by, (a * x + delta * (over - a * energy_)) / time};
}

// A step of t towards `until`, if it is good; the length of the next.
void SpinFall::step(double until) {
    const double left = until - time_, h = std::min(length_, std::fabs(left));
    State wrong{};
    const State next = dormand_prince(
        at_, std::copysign(h, left), [this](const State& s) { return slope(s); }, wrong);
    double error = 0;
    for (const double part : wrong) error = std::max(error, std::fabs(part) / kFallStep);
    if (!(next[0] > outer_)) error = INFINITY;
    if (error > 1.0 || h == length_) length_ = h * next_step_factor(error);
    if (error > 1.0) return;
    at_ = next, time_ = h < std::fabs(left) ? time_ + std::copysign(h, left) : until;
}

SpinFall::Place SpinFall::at(double t) {
    if ((t < 0.0) != (time_ < 0.0) || std::fabs(t) < std::fabs(time_)) at_ = start_, time_ = 0, length_ = kFallFirst;
    const auto frozen = [this] { return !(at_[0] > outer_ * (1.0 + kFallFrozen)); };
    while (time_ != t && !frozen()) step(t);
    if (frozen()) {
        const double horizon = metric_.a() / (outer_ * outer_ + metric_.a() * metric_.a());  // its angular velocity
        return {at_[0], at_[2], at_[4] + horizon * (t - time_), 0, 0, horizon};
    }
    const State rate = slope(at_);
    return {at_[0], at_[2], at_[4], rate[0], rate[2], rate[4]};
}

}  // namespace nullscope
