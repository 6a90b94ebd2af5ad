#include "observer/worldline.h"

#include <algorithm>
#include <cmath>

#include "numeric/dormand_prince.h"
#include "observer/lorentz.h"
#include "observer/observer.h"
#include "observer/pose.h"
#include "spacetime/spherical_metric.h"
#include "spacetime/tortoise.h"

namespace nullscope {
namespace {

constexpr double kTolerance = 1e-13;  // of a step, relative to what it acts on
constexpr double kNearest = 5e-4;     // r_s: the last picture before the singularity, 7e-6 r_s/c before the end
// c: a boost that is rounding alone calls for no aberration, and turns directions by less than any pixel.
constexpr double kStill = 1e-11;
constexpr double kOverThePoles = 1e-9;  // cosine of an orbit's inclination: an azimuth then jumps and does not turn
constexpr std::size_t kMostNodes = 1000000;

double square(double x) { return x * x; }

// d f/dr by differences, Richardson once: within 1e-11 where f changes over r itself.
template <class F>
double slope_of(const F& f, double r) {
    const double h = 2e-3 * std::max(std::fabs(r), 1e-3);
    const auto central = [&](double step) { return (f(r + step) - f(r - step)) / (2 * step); };
    return (4 * central(0.5 * h) - central(h)) / 3;
}

// dA/dr.
double lapse_slope(const Spacetime& spacetime, double r) {
    if (!spacetime.bends_light() || spacetime.by_proper_length()) return 0.0;
    const OrbitEquation* orbit = spacetime.orbit_equation();
    if (orbit == nullptr) return slope_of([&](double x) { return spacetime.lapse_squared(x); }, r);
    return -orbit->lapse_slope(1.0 / r) / (r * r);
}

// dR/dr.
double areal_slope(const Spacetime& spacetime, double r) {
    if (spacetime.orbit_equation() != nullptr) return 1.0;
    return slope_of([&](double x) { return spacetime.areal_radius(x); }, r);
}

// The radial frame that a place on a worldline is described in: rain about a hole, or at rest.
CameraSpec without_motion(CameraSpec camera, const Spacetime& spacetime) {
    camera.observer = spacetime.horizon_radius() ? ObserverKind::kRain : ObserverKind::kStatic;
    camera.velocity = {};
    return camera;
}

}  // namespace

// v' of the two forms the one that does not cancel.
double Worldline::v_slope(const State& s) const {
    if (s[1] < 0) return (1 + square(momentum_ / spacetime_->areal_radius(s[0]))) / (energy_ - s[1]);
    return (energy_ + s[1]) / spacetime_->lapse_squared(s[0]);
}

Worldline::State Worldline::slope(const State& s) const {
    const Spacetime& spacetime = *spacetime_;
    const double r = s[0], speed = s[1], radius = spacetime.areal_radius(r), a = spacetime.lapse_squared(r);
    const double a_slope = lapse_slope(spacetime, r), r_slope = areal_slope(spacetime, r),
                 turn = momentum_ / square(radius);
    const double across2 = square(momentum_ / radius);
    State d{};
    d[0] = speed;
    d[1] = -0.5 * a_slope * (1 + across2) + a * across2 * r_slope / radius;
    d[2] = turn;
    const double by_v = 0.5 * a_slope * v_slope(s), by_turn = turn * r_slope;
    for (std::size_t i = 3; i < kAxes; i += 3) {
        d[i] = -by_v * s[i] + by_turn * s[i + 2];
        d[i + 1] = by_v * s[i + 1] - a * by_turn * s[i + 2];
        d[i + 2] = -by_turn * (a * s[i] - s[i + 1]) / 2;
    }
    d[kClock] = spacetime.horizon_radius() ? v_slope(s) - speed : energy_ / a;
    return d;
}

Worldline::State Worldline::step(const State& s, double h, double& error) const {
    State wrong{};
    const State next = dormand_prince(
        s, h, [this](const State& at) { return slope(at); }, wrong);
    error = 0;
    for (std::size_t n = 0; n < kSize; ++n) {
        const double scale = n == 0 ? std::max(std::fabs(s[0]), 1e-9) : std::max(std::fabs(s[n]), 1.0);
        error = std::max(error, std::fabs(wrong[n]) / scale);
    }
    return next;
}

Result<Worldline> Worldline::make(std::shared_ptr<const Spacetime> spacetime, const CameraSpec& start,
                                  double duration) {
    if (spacetime->rotates()) {
        TRY(spun, SpinWorldline::make(std::move(spacetime), start, duration));
        Worldline line;
        line.energy_ = spun->energy(), line.last_ = line.end_time_ = spun->last(),
        line.horizon_time_ = spun->horizon_time();
        line.end_ = spun->reaches_inner_horizon() ? WorldlineEnd::kSurface : WorldlineEnd::kOpen;
        line.spun_ = std::make_shared<const SpinWorldline>(std::move(*spun));
        return line;
    }
    TRY(observer, observer_of(*spacetime, start));
    Worldline line;
    line.spacetime_ = std::move(spacetime);
    line.start_ = start;
    const double o = observer->frame.outward;
    // Columns: the camera's 4-velocity and axes along the radial frame (t, r, theta, phi).
    const Mat3 axes = observer->turn * static_from_camera(start);
    Lorentz tetrad{};
    tetrad[0][0] = 1;
    const Vec3 columns[3] = {axes.a, axes.b, axes.c};
    for (std::size_t i = 0; i < 3; ++i)
        tetrad[1][i + 1] = columns[i].x, tetrad[2][i + 1] = columns[i].y, tetrad[3][i + 1] = columns[i].z;
    tetrad = boost(observer->velocity) * tetrad;
    const double aside = std::hypot(tetrad[2][0], tetrad[3][0]);
    const Vec3 onward = aside > 0 ? Vec3{0, tetrad[2][0] / aside, tetrad[3][0] / aside} : Vec3{0, 0, 1},
               normal = cross({1, 0, 0}, onward);
    const Mat3 world = world_from_static(start.theta, start.phi);
    line.outward_ = world.a, line.onward_ = world * onward, line.normal_ = world * normal;
    const double a = line.spacetime_->lapse_squared(start.r), m = (tetrad[0][0] + tetrad[1][0]) / o,
                 n = (tetrad[0][0] - tetrad[1][0]) * o;
    line.ahead_ = line.spacetime_->horizon_radius() && !falls(start) ? time_ahead(*line.spacetime_, start.r) : 0;
    line.energy_ = 0.5 * (a * m + n);
    line.momentum_ = aside * line.spacetime_->areal_radius(start.r);
    State state{start.r, 0.5 * (a * m - n), 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = i + 1;
        const Vec3 side{0, tetrad[2][j], tetrad[3][j]};
        state[3 + 3 * i] = (tetrad[0][j] + tetrad[1][j]) / o;
        state[4 + 3 * i] = (tetrad[0][j] - tetrad[1][j]) * o;
        state[5 + 3 * i] = dot(side, onward);
        line.across_[i] = dot(side, normal);
    }
    line.nodes_.push_back({0, state});
    line.run(duration);
    return line;
}

void Worldline::run(double duration) {
    const auto horizon = spacetime_->horizon_radius();
    const RadiusRange range = spacetime_->falling_range();
    const bool singular = horizon && range.low == 0.0;
    const double low = singular ? kNearest : range.low;
    double h = 1e-3 * std::min(duration, spacetime_->areal_radius(start_.r));
    while (nodes_.size() < kMostNodes) {
        const Node& now = nodes_.back();
        if (now.tau >= duration) break;
        h = std::min(h, duration - now.tau);
        double error = 0;
        const State next = step(now.state, h, error);
        const bool good = error <= kTolerance && std::isfinite(error);
        if (good) {
            nodes_.push_back({now.tau + h, next});
            if (horizon && !horizon_time_ && next[0] <= *horizon && nodes_.front().state[0] > *horizon)
                horizon_time_ = time_at_radius(*horizon);
            if (next[0] <= low) {
                end_ = singular ? WorldlineEnd::kSingularity : WorldlineEnd::kSurface;
                break;
            }
        }
        h *= next_step_factor(error / kTolerance);
    }
    last_ = end_time_ = nodes_.back().tau;
    if (end_ == WorldlineEnd::kOpen) return;
    last_ = end_time_ = time_at_radius(low);
    if (end_ == WorldlineEnd::kSingularity) finish_at_singularity();
}

// Newton's steps in the radius over the last step.
double Worldline::time_at_radius(double r) const {
    const Node& before = nodes_[nodes_.size() - 2];
    const double whole = nodes_.back().tau - before.tau;
    double h = whole * (before.state[0] - r) / (before.state[0] - nodes_.back().state[0]);
    for (int i = 0; i < 20; ++i) {
        double error = 0;
        const State there = step(before.state, h, error);
        const double by = (there[0] - r) / there[1];
        h = std::clamp(h - by, 0.0, whole);
        if (std::fabs(by) < 1e-15 * (1 + before.tau)) break;
    }
    return before.tau + h;
}

// What is left: the integral of dr / sqrt(E^2 - A (1 + L^2/r^2)) = 2 y dy / sqrt(...), r = y^2, by the midpoint rule twice (Richardson):
// some 1e-5 in all, to 1e-12.
void Worldline::finish_at_singularity() {
    const auto rule = [&](int panels) {
        const double step = std::sqrt(kNearest) / panels;
        double sum = 0;
        for (int i = 0; i < panels; ++i) {
            const double y = (i + 0.5) * step, r = y * y;
            sum +=
                2 * y * step / std::sqrt(square(energy_) - spacetime_->lapse_squared(r) * (1 + square(momentum_ / r)));
        }
        return sum;
    };
    end_time_ = last_ + (4 * rule(2000) - rule(1000)) / 3;
}

Worldline::State Worldline::state_at(double tau) const {
    const double when = std::clamp(tau, 0.0, last_);
    const auto after =
        std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, when, [](double t, const Node& n) { return t < n.tau; });
    const Node& before = nodes_.size() > 1 ? *(after - 1) : nodes_.front();
    double error = 0;
    return step(before.state, when - before.tau, error);
}

double Worldline::clock(double tau) const { return spun_ ? spun_->clock(tau) : ahead_ + state_at(tau)[kClock]; }

// The angle along the orbit and the azimuth are at the same quarter of a turn from the node at any time.
double Worldline::azimuth(double tau) const {
    if (spun_) return spun_->at(0).phi + spun_->azimuth(tau);
    const double along = state_at(tau)[2], up = normal_.z;
    const Vec3 place = std::cos(along) * outward_ + std::sin(along) * onward_;
    const double near = start_.phi + (std::fabs(up) > kOverThePoles ? std::copysign(along, up) : 0.0);
    return near + std::remainder(std::atan2(place.y, place.x) - near, 2 * M_PI);
}

CameraSpec Worldline::at(double tau) const {
    if (spun_) return spun_->at(tau);
    const State s = state_at(tau);
    const double radius = spacetime_->areal_radius(s[0]), co = std::cos(s[2]), si = std::sin(s[2]);
    CameraSpec camera = without_motion(start_, *spacetime_);
    camera.r = s[0];
    const Vec3 place = co * outward_ + si * onward_, onward = co * onward_ - si * outward_;
    camera.theta = std::atan2(std::hypot(place.x, place.y), place.z);
    camera.phi = std::atan2(place.y, place.x);
    const Mat3 local = transposed(world_from_static(camera.theta, camera.phi));
    const double o = observer_of(*spacetime_, camera)->frame.outward;
    const Vec3 along = local * onward, normal = local * normal_;
    Lorentz tetrad{};
    const auto put = [&](std::size_t column, double m, double n, double phi, double across) {
        const Vec3 side = phi * along + across * normal;
        tetrad[0][column] = 0.5 * (o * m + n / o);
        tetrad[1][column] = 0.5 * (o * m - n / o);
        tetrad[2][column] = side.y, tetrad[3][column] = side.z;
    };
    put(0, v_slope(s), energy_ - s[1], momentum_ / radius, 0);
    for (std::size_t i = 0; i < 3; ++i) put(i + 1, s[3 + 3 * i], s[4 + 3 * i], s[5 + 3 * i], across_[i]);
    const BoostAndTurn parts = split(tetrad);
    camera.velocity = length(parts.velocity) > kStill ? parts.velocity : Vec3{};
    set_axes(camera, parts.turn);
    return camera;
}

}  // namespace nullscope
