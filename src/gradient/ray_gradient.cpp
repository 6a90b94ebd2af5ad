#include "gradient/ray_gradient.h"

#include <algorithm>
#include <cmath>

#include "gradient/extrapolated_step.h"

namespace nullscope {
namespace {

constexpr double kTolerance = 1e-12;   // of a step, values and derivatives
constexpr double kNearHorizon = 1e-3;  // of a step next to the horizon, over that of others
constexpr double kOrder = 13.0;        // of the error that steps are chosen by
constexpr double kFirstStep = 0.1;     // of u and of the angle
constexpr double kLongestTurn = 1.0;   // rad, of a step
constexpr double kShare = 0.99;        // of the way to the sky, of a step
constexpr double kAtSky = 1e-8;        // u times the impact parameter, where what is left of the way is straight
constexpr double kLeastStep = 1e-7;    // of the first: at a horizon
constexpr int kMostSteps = 4000;
constexpr double kInPlane = 1e-12;  // a camera whose height is less stands in the plane
constexpr double kOnPlane = 1e-14;  // of a crossing

double largest(const RayState& s, std::size_t first, std::size_t count, double (*part)(const Number&)) {
    double size = 0;
    for (std::size_t i = first; i < first + count; ++i) size = std::max(size, part(s[i]));
    return size;
}
double of_value(const Number& x) { return std::fabs(x.value); }

// Of a step, over what is allowed; not a number where the step left the metric.
class StepError {
public:
    StepError(const RayState& end, const RayState& less_exact, double energy, double innermost)
        : end_(end), other_(less_exact) {
        // What the hole drags is as well known as the distance from the horizon.
        add(kU, 1, 0, std::clamp(1 - end[kU].value / innermost, kNearHorizon, 1.0)), add(kW, 1, energy), add(kN, 3, 0),
            add(kTurn, 3, energy), add(kDragged, 1, 1), add(kTime, 1, 1);
    }
    double value() const { return worst_ / kTolerance; }

private:
    void add(std::size_t first, std::size_t count, double least, double share = 1) {
        const double size = std::max(largest(end_, first, count, of_value), least);
        for (std::size_t i = first; i < first + count; ++i) take(end_[i].value - other_[i].value, share * size);
        for (std::size_t seed = 0; seed < kSeeds; ++seed) {
            double slope = size;
            for (std::size_t i = first; i < first + count; ++i) slope = std::max(slope, std::fabs(end_[i].d[seed]));
            for (std::size_t i = first; i < first + count; ++i)
                take(end_[i].d[seed] - other_[i].d[seed], share * slope);
        }
    }
    void take(double off, double size) {
        const double error = std::fabs(off) / size;
        if (!(error <= worst_)) worst_ = error;  // NaN stays
    }
    const RayState &end_, &other_;
    double worst_ = 0;
};

Triple place_of(const RayState& s) {
    const Number c = cos(s[kDragged]), i = sin(s[kDragged]);
    return {c * s[kN] - i * s[kN + 1], i * s[kN] + c * s[kN + 1], s[kN + 2]};
}

RayState moved(const RayState& s, const RayState& rate, const Number& by) {
    RayState there = s;
    for (std::size_t i = 0; i < kFlowStates; ++i) there[i] = there[i] + by * rate[i];
    return there;
}

Triple normal_of(const DiscLean& lean, double time) {
    const Number tilt = Number::variable(lean.tilt, kSeedTilt);
    const Number node = Number::variable(lean.node + lean.precession * time, kSeedNode);
    const Number up = sin(tilt);
    return {up * sin(node), -(up * cos(node)), cos(tilt)};
}

class Tracer {
public:
    Tracer(const Flow& flow, const Launch& from, const GradientTask& task)
        : flow_(flow), task_(task), normal_(normal_of(task.lean, task.time)) {
        photon_ = flow.launch(from, here_);
        height_ = height(here_);
        if (std::fabs(height_) < kInPlane) height_ = height_rate(here_, slope(here_));
        if (std::fabs(height_) < kInPlane) task_.crossings = 0;  // it stays in the plane
    }

    RayGradient traced() {
        found_.g = 1.0 / photon_.energy;
        const double turn = std::sqrt(squared_turn()), u = here_[kU].value;
        const double first = kFirstStep / (turn + std::fabs(here_[kW].value) / u);
        double length = first;
        for (int steps = 0; steps < kMostSteps && !at_sky(); ++steps) {
            const double longest = longest_step();
            length = std::min(length, longest);
            const RayState rate = slope(here_);
            const auto [end, less_exact] = step(rate, length);
            const double error = StepError(end, less_exact, photon_.energy.value, flow_.innermost()).value();
            if (error <= 1 && end[kU].value > 0) {
                take(end, rate, length);
                length *= std::clamp(0.9 * std::pow(std::max(error, 1e-30), -1 / kOrder), 0.3, 4.0);
            } else {
                length *= std::isfinite(error) ? std::clamp(0.9 * std::pow(error, -1 / kOrder), 0.1, 0.7) : 0.3;
                if (length < kLeastStep * std::min(first, longest)) break;
            }
        }
        if (at_sky()) reach_sky();
        return std::move(found_);
    }

    double off_critical() const;

private:
    RayState slope(const RayState& s) const { return flow_.slope(photon_, s); }
    RayState stepped(const RayState& rate, double length) const { return step(rate, length).end; }
    ExtrapolatedStep<RayState> step(const RayState& rate, double length) const {
        return extrapolated_step(here_, rate, length, [this](const RayState& s) { return slope(s); });
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
    double height(const RayState& s) const { return dot(normal_, place_of(s)).value; }
    // And by how much it grows along the ray.
    double height_rate(const RayState& s, const RayState& rate) const {
        const double part = 1e-3 * kFirstStep / (1 + std::sqrt(squared_turn()));
        return (height(moved(s, rate, Number(part))) - height(moved(s, rate, Number(-part)))) / (2 * part);
    }

    void take(const RayState& end, const RayState& rate, double length) {
        const double after = height(end);
        if (static_cast<int>(found_.crossings.size()) < task_.crossings && (after > 0) != (height_ > 0))
            cross(rate, length, after);
        height_ = after, here_ = end;
    }

    // By regula falsi (Illinois), then one step of Newton's in duals: the place where the height is 0, whatever the seeds.
    void cross(const RayState& rate, double length, double after) {
        double low = 0, high = length, at_low = height_, at_high = after, at = length;
        if (std::fabs(height(here_)) < kInPlane) at_low = std::copysign(1.0, height_);
        RayState there = here_;
        for (int tries = 0; tries < 60; ++tries) {
            at = (low * at_high - high * at_low) / (at_high - at_low);
            there = stepped(rate, at);
            const double now = height(there);
            if (std::fabs(now) < kOnPlane || high - low < kOnPlane * length) break;
            if ((now > 0) == (at_high > 0)) {
                high = at, at_high = now, at_low *= 0.5;
            } else {
                low = at, at_low = now, at_high *= 0.5;
            }
        }
        for (int newton = 0; newton < 2; ++newton) there = on_plane(there);
        const Triple place = place_of(there);
        Number phi(std::atan2(place[1].value, place[0].value));
        const double flat2 = place[0].value * place[0].value + place[1].value * place[1].value;
        for (std::size_t i = 0; i < kSeeds; ++i)
            phi.d[i] = (place[0].value * place[1].d[i] - place[1].value * place[0].d[i]) / flat2;
        found_.crossings.push_back({1.0 / there[kU], phi});
    }

    RayState on_plane(const RayState& s) const {
        const RayState rate = slope(s);
        const Triple place = place_of(s);
        const Triple drift = {rate[kN] - rate[kDragged] * s[kN + 1], rate[kN + 1] + rate[kDragged] * s[kN],
                              rate[kN + 2]};
        const Number c = cos(s[kDragged]), i = sin(s[kDragged]);
        const Triple speed = {c * drift[0] - i * drift[1], i * drift[0] + c * drift[1], drift[2]};
        return moved(s, rate, -(dot(normal_, place) / dot(normal_, speed)));
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
    Triple normal_;
    Photon photon_;
    RayState here_;
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

// Where U has a least value that is nearly 0, light nearly stays. That value over how fast it grows as the view turns.
double Tracer::off_critical() const {
    constexpr int kPlaces = 128;
    const double most = flow_.innermost();
    const auto u_at = [&](double share) { return most * share; };
    const auto value = [&](double share) { return flow_.radial(photon_, Number(u_at(share))).value; };
    double least = std::numeric_limits<double>::infinity(), before = value(0.5 / kPlaces), here = value(1.5 / kPlaces);
    for (int i = 2; i < kPlaces; ++i) {
        const double after = value((i + 0.5) / kPlaces);
        if (here <= before && here <= after) {
            const Number deepest =
                flow_.radial(photon_, Number(u_at(least_place(value, (i - 1.5) / kPlaces, (i + 0.5) / kPlaces))));
            least =
                std::min(least, std::fabs(deepest.value) / std::hypot(deepest.d[kSeedAside], deepest.d[kSeedAcross]));
        }
        before = here, here = after;
    }
    return least;
}

}  // namespace

RayGradient ray_gradient(const Flow& flow, const Launch& from, const GradientTask& task) {
    Tracer tracer(flow, from, task);
    const double off = tracer.off_critical();
    RayGradient found = tracer.traced();
    found.off_critical = off;
    return found;
}

}  // namespace nullscope
