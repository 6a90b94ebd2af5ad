#include "gradient/ray_gradient.h"

#include <algorithm>
#include <cmath>

#include "gradient/extrapolated_step.h"
#include "gradient/step_error.h"

namespace nullscope {
namespace {

constexpr double kOrder = 13.0;        // of the error that steps are chosen by
constexpr double kFirstStep = 0.1;     // of u and of the angle
constexpr double kLongestTurn = 1.0;   // rad, of a step
constexpr double kShare = 0.9999;      // of the way to the sky, of a step
constexpr double kAtSky = 1e-8;        // u times the impact parameter, where what is left of the way is straight
constexpr double kLeastStep = 1e-7;    // of the first
constexpr double kNearest = 1 - 1e-6;  // of the horizon's u, where rays end
constexpr int kMostSteps = 4000;
constexpr double kInPlane = 1e-12;  // a camera whose height is less stands in the plane
constexpr double kAtCrossing =
    4e-3;  // of a step: the rest is one of Runge and Kutta's, whose error is of its fifth power
constexpr int kMostTries = 60;

Triple place_of(const RayState& s) {
    const Number c = cos(s[kDragged]), i = sin(s[kDragged]);
    return {c * s[kN] - i * s[kN + 1], i * s[kN] + c * s[kN + 1], s[kN + 2]};
}

RayState moved(const RayState& s, const RayState& rate, const Number& by) {
    RayState there = s;
    for (std::size_t i = 0; i < kFlowStates; ++i) there[i] = there[i] + by * rate[i];
    return there;
}

Number azimuth_of(const Number& x, const Number& y) {
    const double flat2 = x.value * x.value + y.value * y.value;
    Number phi(std::atan2(y.value, x.value));
    for (std::size_t i = 0; i < kSeeds; ++i) phi.d[i] = (x.value * y.d[i] - y.value * x.d[i]) / flat2;
    return phi;
}

// On [0, 1], of the cubic with these values and slopes at its ends, the values of both signs; by halves, so that it is within.
double zero_of_cubic(double from, double slope_from, double to, double slope_to) {
    const auto value = [&](double t) {
        const double s = 1 - t;
        return s * s * ((1 + 2 * t) * from + t * slope_from) + t * t * ((1 + 2 * s) * to - s * slope_to);
    };
    double low = 0, high = 1;
    for (int halves = 0; halves < 20; ++halves) {
        const double middle = 0.5 * (low + high);
        ((value(middle) > 0) == (to > 0) ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

// As scene/disc_plane.h has it.
struct Plane {
    Triple x, y, normal;
    Plane(const DiscLean& lean, double time) {
        const Number tilt = Number::variable(lean.tilt, kSeedTilt);
        const Number node = Number::variable(lean.node + lean.precession * time, kSeedNode);
        const Number up = sin(tilt), c = cos(node), s = sin(node), half = sin(0.5 * tilt), less = 2.0 * half * half;
        x = {1.0 - s * s * less, s * c * less, -(s * up)};
        y = {s * c * less, 1.0 - c * c * less, c * up};
        normal = {up * s, -(up * c), cos(tilt)};
    }
};

Triple vector_product(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class Tracer {
public:
    Tracer(const Flow& flow, const Launch& from, const GradientTask& task)
        : flow_(flow), task_(task), plane_(task.lean, task.time) {
        photon_ = flow.launch(from, here_);
        height_ = height(here_);
        if (std::fabs(height_) < kInPlane) height_ = dot(plane_.normal, speed(here_, slope(here_))).value;
        if (std::fabs(height_) < kInPlane) task_.crossings = 0;  // it stays in the plane
    }

    RayGradient surveyed() {
        found_.g = 1.0 / photon_.energy, found_.photon = photon_;
        survey();
        found_.falls_in = falls_;
        return std::move(found_);
    }

    RayGradient traced() {
        found_ = surveyed();
        const double turn = std::sqrt(squared_turn()), u = here_[kU].value;
        const double first = kFirstStep / (turn + std::fabs(here_[kW].value) / u);
        double length = first;
        for (int steps = 0; steps < kMostSteps && !done(); ++steps) {
            const double longest = longest_step();
            length = std::min(length, longest);
            const RayState rate = slope(here_);
            const auto [end, less_exact, enough] = step(rate, length);
            const double error = enough ? kEasyStep : error_of(end, less_exact);
            const bool within = end[kU].value < flow_.innermost();
            if (error <= 1 && within && end[kU].value > 0) {
                take(end, rate, length);
                length *= std::clamp(0.9 * std::pow(std::max(error, 1e-30), -1 / kOrder), 0.3, 4.0);
            } else if (error <= 1 && within) {  // beyond the sky: u is concave there
                length *= kShare * here_[kU].value / (here_[kU].value - end[kU].value);
            } else {
                length *= std::isfinite(error) ? std::clamp(0.9 * std::pow(error, -1 / kOrder), 0.1, 0.7) : 0.3;
                if (length < kLeastStep * std::min(first, longest)) break;
            }
        }
        if (at_sky()) reach_sky();
        return std::move(found_);
    }

private:
    RayState slope(const RayState& s) const { return flow_.slope(photon_, s, here_[kW].value < 0); }
    RayState stepped(const RayState& rate, double length) const { return step(rate, length).end; }
    ExtrapolatedStep<RayState> step(const RayState& rate, double length) const {
        return extrapolated_step(
            here_, rate, length, [this](const RayState& s) { return slope(s); },
            [this](const RayState& end, const RayState& less_exact) { return error_of(end, less_exact) <= 1; });
    }
    double error_of(const RayState& end, const RayState& less_exact) const {
        StepError off(end, less_exact);
        off.add_ray(photon_.energy.value, flow_.innermost()), off.add(kTime, 1, 1);
        return off.over(task_.tolerance);
    }
    double squared_turn() const {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += here_[kTurn + i].value * here_[kTurn + i].value;
        return sum;
    }
    bool at_sky() const {
        const double impact = 1 + std::sqrt(squared_turn()) / std::fabs(photon_.energy.value);
        return here_[kW].value < 0 && here_[kU].value * impact < kAtSky;
    }
    double longest_step() const {
        const double turn = kLongestTurn / std::sqrt(std::max(squared_turn(), 1e-300));
        return here_[kW].value < 0 ? std::min(turn, kShare * here_[kU].value / -here_[kW].value) : turn;
    }
    double height(const RayState& s) const { return dot(plane_.normal, place_of(s)).value; }
    void survey();
    bool done() const {
        const bool all = static_cast<int>(found_.crossings.size()) >= task_.crossings;
        return at_sky() || (here_[kW].value < 0 && here_[kU].value * task_.farthest < 1) ||
               (falls_ &&
                (all || here_[kU].value > kNearest * flow_.innermost() || here_[kU].value * task_.nearest > 1));
    }

    void take(const RayState& end, const RayState& rate, double length) {
        const double after = height(end);
        if (static_cast<int>(found_.crossings.size()) < task_.crossings && (after > 0) != (height_ > 0))
            cross(end, rate, length, after);
        height_ = after, here_ = end;
    }
    double climb(const RayState& s, const RayState& rate) const { return dot(plane_.normal, speed(s, rate)).value; }

    // Within a bracket by Newton's steps, which begin with the cubic of both ends; the last ones in duals: the place where the height is 0, whatever
    // the seeds.
    void cross(const RayState& end, const RayState& rate, double length, double after) {
        double low = 0, high = length,
               at =
                   length * zero_of_cubic(height_, length * climb(here_, rate), after, length * climb(end, slope(end)));
        RayState there = here_;
        for (int tries = 0; tries < kMostTries; ++tries) {
            there = stepped(rate, at);
            const double now = height(there), move = -now / climb(there, slope(there));
            if (std::fabs(move) < kAtCrossing * length) break;
            ((now > 0) == (after > 0) ? high : low) = at;
            at = at + move > low && at + move < high ? at + move : 0.5 * (low + high);
        }
        for (int newton = 0; newton < 2; ++newton)
            there = short_step(there, -height(there) / climb(there, slope(there)));
        for (int newton = 0; newton < 2; ++newton) there = on_plane(there);
        const Triple place = place_of(there);
        RayState turn = there;
        for (std::size_t i = 0; i < 3; ++i) turn[kN + i] = there[kTurn + i];
        found_.crossings.push_back({1.0 / there[kU], azimuth_of(place[0], place[1]),
                                    azimuth_of(dot(plane_.x, place), dot(plane_.y, place)), there[kW],
                                    -dot(plane_.normal, vector_product(place, place_of(turn))), place[2]});
    }

    // Of the classical method by C. Runge and W. Kutta.
    RayState short_step(const RayState& s, double length) const {
        const RayState first = slope(s), second = slope(moved(s, first, 0.5 * length)),
                       third = slope(moved(s, second, 0.5 * length)), last = slope(moved(s, third, length));
        RayState end = s;
        for (std::size_t i = 0; i < kFlowStates; ++i)
            end[i] = end[i] + (length / 6) * (first[i] + 2.0 * (second[i] + third[i]) + last[i]);
        return end;
    }
    RayState on_plane(const RayState& s) const {
        const RayState rate = slope(s);
        return moved(s, rate, -(dot(plane_.normal, place_of(s)) / dot(plane_.normal, speed(s, rate))));
    }
    // Of place_of.
    static Triple speed(const RayState& s, const RayState& rate) {
        RayState drift = s;
        drift[kN] = rate[kN] - rate[kDragged] * s[kN + 1];
        drift[kN + 1] = rate[kN + 1] + rate[kDragged] * s[kN], drift[kN + 2] = rate[kN + 2];
        return place_of(drift);
    }

    void reach_sky() {
        const RayState rate = slope(here_);
        const RayState end = moved(here_, rate, -(here_[kU] / here_[kW]));
        Triple direction = place_of(end);
        const Number size = sqrt(dot(direction, direction));
        for (Number& part : direction) part = part / size;
        found_.sky = {direction, end[kTime]};
    }

    const Flow& flow_;
    GradientTask task_;
    Plane plane_;
    Photon photon_;
    RayState here_;
    bool falls_ = false;
    double height_ = 0;  // over the plane, before the next step
    RayGradient found_;
};

// Of a function with one minimum between the two.
template <class Function>
double least_place(const Function& value, double low, double high) {
    for (int k = 0; k < 60; ++k) {
        const double third = (high - low) / 3;
        if (value(low + third) < value(high - third))
            high -= third;
        else
            low += third;
    }
    return 0.5 * (low + high);
}

// Where U has a least value that is nearly 0, light nearly stays. That value over how fast it grows as the view turns. And what has U > 0 all the
// way in falls in.
void Tracer::survey() {
    constexpr int kPlaces = 128;
    const double most = flow_.innermost(), from = here_[kU].value;
    const auto value = [&](double u) { return flow_.radial(photon_, Number(u)).value; };
    falls_ = here_[kW].value > 0 && value(most) > 0;
    double before = value(0.5 * most / kPlaces), here = value(1.5 * most / kPlaces);
    for (int i = 2; i < kPlaces; ++i) {
        const double after = value((i + 0.5) * most / kPlaces);
        if (here <= before && here <= after) {
            const double u = least_place(value, (i - 1.5) * most / kPlaces, (i + 0.5) * most / kPlaces);
            const Number deepest = flow_.radial(photon_, Number(u));
            const double off = std::fabs(deepest.value) / std::hypot(deepest.d[kSeedAside], deepest.d[kSeedAcross]);
            if (off < found_.off_critical) found_.off_critical = off, found_.clearance = deepest;
            falls_ = falls_ && (u < from || deepest.value > 0);
        }
        before = here, here = after;
    }
}

}  // namespace

RayGradient ray_survey(const Flow& flow, const Launch& from) { return Tracer(flow, from, {}).surveyed(); }

RayGradient ray_gradient(const Flow& flow, const Launch& from, const GradientTask& task) {
    return Tracer(flow, from, task).traced();
}

}  // namespace nullscope
