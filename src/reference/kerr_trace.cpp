#include "reference/kerr_trace.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {
namespace {

// Of each step, over the sizes of what is integrated.
constexpr double kStepTolerance = 1e-14;
constexpr double kLargeMomentum = 1e-3;  // of a momentum: below that part errors are its rounding's
constexpr double kFirstStep = 0.05;      // rad, about
constexpr double kLongestArc = 1;        // rad: no step goes half round the hole,
constexpr double kSureTurn = 1.5;        // nor is dragged round so far that of such a turn the sense would not be sure
// 1/r_s: nearer than that light may have no energy, and the clock is t; farther off t would not be smooth.
constexpr double kNearHole = 0.5;
constexpr double kNearStep = 0.3;  // of u, of a step outward that t is integrated along
// A ray has reached the sky where what is left of its bending, M b u^2, is below rounding: u = kSky/sqrt(b).
constexpr double kSky = 1e-8;
// How well the way to the sky is known from flat space, of itself: u (b u)^2 and (a u)^2, and some room.
constexpr double kRoom = 4;
constexpr int kMostSteps = 20000;  // near-critical rays take some hundred
// of a step: a zero that is known so well needs no more than the slope there
constexpr double kAtCrossing = 1e-8;
constexpr int kMostTries = 60;
// the root of Carter's constant over E, r_s, below which the ray of a camera in the plane stays in it
constexpr double kStaysThere = 5e-11;

}  // namespace

KerrTrace::KerrTrace(const KerrHole& hole, const KerrLaunch& launch, const Start& start, int most_crossings,
                     const KerrWatch* watch)
    : chart_{hole}, flow_(hole), most_crossings_(most_crossings), watch_(watch), outer_(hole.outer()) {
    begin(launch, start);
    outside_ = launch.r > outer_;  // as it is given: radius() of the state has a rounding of its own
    ray_.energy = launch.energy;
    ray_.l_z = launch.l_over_sine * std::sin(launch.theta) / launch.energy;
    ray_.fate = outside_ ? Fate::kCaptured : Fate::kNoSky;
    // From inside, what does not come out through this horizon: E (r_+^2 + a^2) <= a L.
    if (!outside_ &&
        !(launch.energy * chart_.horizon_area(outer_) > chart_.a * launch.l_over_sine * std::sin(launch.theta)))
        done_ = true;
    else if (at_sky(here_.state))
        reach_sky();
}

void KerrTrace::begin(const KerrLaunch& launch, const Start& start) {
    const KerrBeginning from = beginning(chart_, launch);
    here_ = {};
    here_.leg = {launch.phi, launch.sense() * launch.energy, from.momentum.z, launch.sense(), start.base};
    here_.state = {from.n.x, from.n.y, from.n.z, from.momentum.x, from.momentum.y, from.u, from.c, 0};
    here_.along = start.along, here_.azimuth = from.azimuth, from_ = start.from;
    set_clock();
    here_.time = -clock_time(here_, here_.state);
    stays_ = from.n.z == 0 && std::abs(launch.p_theta) < kStaysThere * std::abs(launch.energy);
    steps_ = 0;
    const double j = momentum(here_.state);
    length_ = kFirstStep / (j + std::hypot(from.c, from.u * j));
    want_step();
}

FlowRay<double> KerrTrace::flow_ray(const Here& from) {
    return {from.leg.energy, from.leg.j_z, from.clock == FlowClock::kNear ? 0.0 : 1.0,
            from.clock == FlowClock::kFarLogarithm ? 1.0 : 0.0};
}

KerrTrace::State KerrTrace::slope(const Here& from, const State& s) const {
    State d;
    flow_.slope(flow_ray(from), s, d);
    return d;
}

KerrTrace::State KerrTrace::stepped(const Here& from, double length) const {
    FlowTask<double> task{};
    task.ray = flow_ray(from), task.start = from.state, task.length = length;
    FlowStep<double>(flow_, task);
    return task.end;
}

KerrPhase KerrTrace::phase(const Here& from, const State& s) {
    const Vec3 n{s[0], s[1], s[2]}, j{s[3], s[4], from.leg.j_z};
    return {n / s[5], s[6] * n + s[5] * cross(j, n)};
}

double KerrTrace::radius(const State& s) const {
    return KerrFlow::round(s[2], (flow_.a * s[5]) * (flow_.a * s[5])).ratio / s[5];
}

// Of the azimuth along a step. Light goes round a part of a great circle, by less than half a turn in the sense of L_z,
// and is dragged round, by little: next to the axis that decides where atan2 may be off by a turn.
double KerrTrace::turned(const Here& from, const State& to, double length) const {
    const double x = from.state[0], y = from.state[1];
    if (x == 0 && y == 0) return std::remainder(std::atan2(to[1], to[0]) - from.azimuth, 2 * M_PI);  // from the axis
    const double turn = std::atan2(x * to[1] - y * to[0], x * to[0] + y * to[1]);
    if (std::abs(turn) < kSureTurn) return turn;
    const double drag = 0.5 * length * (dragging(from, from.state) + dragging(from, to));
    const double own = std::remainder(turn - drag, 2 * M_PI), sense = from.leg.j_z;
    return drag + own + (std::abs(own) > 0.5 * M_PI && own * sense < 0 ? std::copysign(2 * M_PI, sense) : 0.0);
}

// How fast the azimuth grows of light with L_z = 0, of the chart.
double KerrTrace::dragging(const Here& from, const State& s) const {
    const auto [x, p] = phase(from, s);
    const double r = chart_.radius(x);
    return flow_.a * chart_.pull(from.leg.energy, x, p).delay / ((r * r + flow_.a * flow_.a) * s[5] * s[5]);
}

void KerrTrace::want(double length) {
    const State& s = here_.state;
    const double j = momentum(s), p = std::sqrt(s[6] * s[6] + (s[5] * j) * (s[5] * j));
    task_.ray = flow_ray(here_);
    task_.start = s, task_.length = length;
    // Where light climbs out next to the horizon the ingoing chart has it with a large momentum, of which little is left
    // farther out: errors count by its energy.
    const double size = std::abs(here_.leg.energy) + kLargeMomentum * p;
    task_.j_weight = 1 / (j + size), task_.u_weight = 1 / std::max(1.0, s[5]), task_.c_weight = 1 / size;
}

void KerrTrace::want_step() { want(longest_step(length_)); }

double KerrTrace::longest_step(double length) const {
    const double u = here_.state[5], c = here_.state[6], j = momentum(here_.state);
    length = std::min(length, kLongestArc / j);
    if (c <= 0) return length;
    return std::min(length, here_.clock == FlowClock::kNear ? kNearStep * u / c : near_sky(j));
}

// The way to the sky as it is in flat space, u = (p/J) sin(J s), but for what that may be off, and at last to where the
// sky is reached.
double KerrTrace::near_sky(double j) const {
    const double u = here_.state[5], c = here_.state[6], across = j * u, p2 = c * c + across * across;
    const double whole = j > 0 ? std::atan2(across, c) / j : u / c;
    const double off = kRoom * (across * across / p2 * u + flow_.a * flow_.a * u * u), sky = sky_at(j);
    return off * u < sky ? whole - 0.25 * sky / c : whole * (1 - std::min(off, 0.4));
}

double KerrTrace::sky_at(double j) const { return kSky / std::sqrt(std::max(1.0, j / std::abs(here_.leg.energy))); }

void KerrTrace::take() {
    if (crossing_)
        take_crossing();
    else
        take_step();
    if (!done_ && !crossing_) want_step();
}

void KerrTrace::take_step() {
    const double taken = task_.length, error = step_error(task_, kStepTolerance);
    length_ = taken * next_step(error);
    if (++steps_ > kMostSteps) done_ = true;  // still winding: closer to the critical ray than a double can tell
    if (!(error <= 1)) return;
    const State end = task_.end;
    if (watch_) show(end, taken);
    const double z = here_.state[2];
    if (z != 0 && (z > 0) != (end[2] > 0) && !stays_ && static_cast<int>(ray_.crossings.size()) < most_crossings_)
        seek_crossing(end, taken);
    else
        go_on(end, taken);
}

// First where the cubic is 0 that has the values and slopes of n_z at both ends; then by Newton's steps, each taken whole
// from where the step began.
void KerrTrace::seek_crossing(const State& end, double taken) {
    const double z0 = here_.state[2], z1 = end[2], d0 = taken * slope(here_, here_.state)[2],
                 d1 = taken * slope(here_, end)[2];
    double low = 0, high = 1, at = z0 / (z0 - z1);
    for (int i = 0; i < 8; ++i) {
        const double left = 1 - at,
                     value = left * left * (z0 * (1 + 2 * at) + d0 * at) + at * at * (z1 * (1 + 2 * left) - d1 * left),
                     rate = 6 * at * left * (z1 - z0) + d0 * left * (1 - 3 * at) + d1 * at * (3 * at - 2);
        ((value > 0) == (z0 > 0) ? low : high) = at;
        const double next = at - value / rate;
        at = next > low && next < high ? next : 0.5 * (low + high);
    }
    crossing_ = Crossing{end, taken, 0, taken, at * taken};
    want(crossing_->at);
}

void KerrTrace::take_crossing() {
    Crossing& c = *crossing_;
    State there = task_.end;
    const State d = slope(here_, there);
    double move = -there[2] / d[2];
    ((there[2] > 0) == (here_.state[2] > 0) ? c.low : c.high) = c.at;
    const bool found = std::abs(move) <= kAtCrossing * c.taken, gives_up = ++c.tries >= kMostTries;
    if (!found && !gives_up) {
        const double next = c.at + move;
        c.at = next > c.low && next < c.high ? next : 0.5 * (c.low + c.high);
        want(c.at);
        return;
    }
    if (!found) move = 0;
    for (std::size_t n = 0; n < kFlowSize; ++n) there[n] += move * d[n];
    add_crossing(there, c.at + move);
    const State end = c.end;
    const double taken = c.taken;
    crossing_.reset();
    go_on(end, taken);
}

void KerrTrace::add_crossing(const State& there, double at) {
    const double r = radius(there);
    if (!(r > outer_)) return;
    const auto [x, p] = phase(here_, there);
    const Vec3 motion = p + chart_.pull(here_.leg.energy, x, p).drift;
    // p^r = dr/dlambda of what is traced, with N sqrt(g_rr) = r/sqrt(g_phiphi); the photon's own has the other sign.
    const double climb = -chart_.rising(x, motion) * r / (ray_.energy * std::sqrt(chart_.g_phiphi(r)));
    ray_.crossings.push_back({here_.along + at, r, azimuth(here_, there, at, r), climb, delay(here_, there), ray_.l_z});
    ray_.crossings.back().bearing = ray_.crossings.back().phi;
}

// On to where a step has come.
void KerrTrace::go_on(const State& state, double taken) {
    here_.azimuth += turned(here_, state, taken);
    here_.state = state, here_.along += taken;
    straighten();
    set_clock();
    const double r = radius(state);
    if (r <= outer_ && outside_) {
        done_ = true;
        return;
    }
    outside_ = outside_ || r > outer_;
    if (here_.leg.sense < 0 && outside_) {
        const auto [x, p] = phase(here_, state);
        if (chart_.rising(x, p + chart_.pull(here_.leg.energy, x, p).drift) < 0) return follow_mirrored(r);
    }
    if (at_sky(state)) reach_sky();
}

// n is a unit vector across J but for errors of steps, which grow exponentially where light winds next to the horizon.
void KerrTrace::straighten() {
    State& s = here_.state;
    const double j = here_.leg.j_z, j2 = s[3] * s[3] + s[4] * s[4] + j * j;
    const double lean = j2 > 0 ? (s[0] * s[3] + s[1] * s[4] + s[2] * j) / j2 : 0;
    s[0] -= lean * s[3], s[1] -= lean * s[4], s[2] -= lean * j;
    const double back = 1 / std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    s[0] *= back, s[1] *= back, s[2] *= back;
}

void KerrTrace::set_clock() {
    State& s = here_.state;
    const FlowClock next = !(s[5] < kNearHole) || here_.leg.energy == 0 ? FlowClock::kNear
                           : here_.leg.energy > 0 && s[6] > 0           ? FlowClock::kFarLogarithm
                                                                        : FlowClock::kFar;
    if (next == here_.clock) return;
    here_.time += clock_time(here_, s);
    s[7] = 0, here_.clock = next;
    here_.time -= clock_time(here_, s);
}

// Of a photon that was traced as it is and has turned, on its way to the past horizon now.
void KerrTrace::follow_mirrored(double r) {
    const KerrLaunch launch =
        mirrored(chart_, phase(here_, here_.state), ray_.energy, azimuth(here_, here_.state, 0, r));
    begin(launch, {static_cast<long double>(delay(here_, here_.state)) + chart_.tortoise_ahead(r), from_, here_.along});
}

// The motion's direction, nearer to the sky's than the place's.
void KerrTrace::reach_sky() {
    done_ = true;
    ray_.fate = Fate::kEscaped;
    const State& s = here_.state;
    const Vec3 motion = phase(here_, s).p;
    const double to_motion = std::remainder(std::atan2(motion.y, motion.x) - std::atan2(s[1], s[0]), 2 * M_PI);
    ray_.phi_inf = here_.leg.phi - here_.leg.sense * (here_.azimuth + to_motion);
    const double flat = std::hypot(motion.x, motion.y), all = std::hypot(flat, motion.z);
    ray_.sky = {flat / all * std::cos(ray_.phi_inf), flat / all * std::sin(ray_.phi_inf), motion.z / all};
    ray_.delay = delay_from_sky();
}

// The chart's time since the start that is in the clock of a state (FlowClock).
long double KerrTrace::clock_time(const Here& from, const State& s) {
    if (from.clock == FlowClock::kNear) return s[7];
    const long double way = static_cast<long double>(s[6]) / s[5];
    const double logarithm = from.clock == FlowClock::kFarLogarithm ? 2 * std::log(s[5]) : 0.0;
    return (s[7] + way) / from.leg.energy - logarithm;
}

// The chart's t is v - r of what is traced: of the mirror image -t + r_* - r.
double KerrTrace::delay(const Here& from, const State& s) const {
    const long double passed = from.time + clock_time(from, s);
    return static_cast<double>(from.leg.base + from.leg.sense * (passed - chart_.tortoise_ahead(radius(s))));
}

// T, as u goes to 0: delay + from - r_*. There x p/energy is r but for b^2/r, which the rest of a straight way takes
// back, and the logarithms of the clock and of r_* are one; of the mirror image 2 H (l p)^2/(2 energy u) is left of
// p/energy - 1. What is left of the clock is small.
double KerrTrace::delay_from_sky() const {
    const State& s = here_.state;
    const double clock = (s[7] + slope(here_, s)[7] * s[5] / s[6]) / here_.leg.energy;
    const Leg& leg = here_.leg;
    return static_cast<double>(leg.base + from_ + leg.sense * (here_.time + clock) + (leg.sense > 0 ? 2 : 0));
}

KerrTrace begin_trace(const KerrHole& hole, const KerrStart& start, int most_crossings, const KerrWatch* watch) {
    const KerrChart chart{hole};
    const long double ahead = chart.tortoise_ahead(start.r);
    return {hole, kerr_launch(chart, start), {ahead, start.r + ahead}, most_crossings, watch};
}

KerrTrace begin_trace(const KerrHole& hole, const KerrPhoton& photon, int most_crossings, bool falls,
                      const KerrWatch* watch) {
    const KerrChart chart{hole};
    const KerrLaunch launch = kerr_launch(chart, photon);
    // delay = 0 at the camera, or r_* - r; inside the horizon what is traced fell in, and r_* is not asked for.
    const long double sense = launch.sense(), ahead = falls && launch.falls ? 0 : chart.tortoise_ahead(photon.r);
    return {hole,
            launch,
            {falls ? ahead + sense * ahead : sense * ahead, photon.r + (falls ? 0 : ahead)},
            most_crossings,
            watch};
}

}  // namespace nullscope::reference
