#include "reference/kerr_ray.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/kerr_between.h"
#include "reference/kerr_launch.h"
#include "reference/kerr_step.h"

namespace nullscope::reference {
namespace {

// Of each step, absolute and relative; the steps' errors add up to some ten times this.
constexpr double kStepTolerance = 1e-14;
// Of the distance to the hole, on the way to it: a step that is longer would not see it.
constexpr double kLongestStep = 0.5;
// What a step along a straight line may leave out of the bending, rad, and on the way out until T is read of the time,
// r_s/c.
constexpr double kBending = 1e-14, kLate = 1e-12;
// Of the distance to the hole: a ray that is further off its straight line gets a new one.
constexpr double kBent = 0.1;
// A ray has reached the sky where what is left of its bending, M b / R^2, is below rounding.
constexpr double kSky = 1e9;
// Where T is read, in impact parameters on the way out, at least r_s: further on it loses what rounding makes of x,
// nearer M b^2/R^2.
constexpr double kFarForTime = 1e4;
constexpr int kMostSteps = 20000;  // near-critical rays take some hundred
// of its radius: how near to it a ray is shown; nearer, rounding turns the azimuth by 1e-7 rad and more
constexpr double kAboveHorizon = 1e-9;
constexpr double kAxis = 1e-9;  // of the sine of the polar angle, within which that does not change
constexpr int kHalvings = 40;   // of a step through the horizon: beyond them is rounding
// the root of Carter's constant over E, r_s, below which the ray of a camera in the plane stays in it
constexpr double kStaysThere = 5e-11;

// Of the azimuth along a step that begins at azimuth `at`, in (-pi, pi]; where that is near half a turn the motion's
// own sense decides.
double turned(double at, const Vec3& from, const Vec3& to, const Vec3& velocity) {
    if (from.x == 0 && from.y == 0) return std::remainder(std::atan2(to.y, to.x) - at, 2 * M_PI);  // from the axis
    double turn = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    const double sense = from.x * velocity.y - from.y * velocity.x;
    if (std::abs(turn) > 2.5 && turn * sense < 0) turn += sense > 0 ? 2 * M_PI : -2 * M_PI;
    return turn;
}

class Path {
public:
    // The camera's clock less t is base + (r_* - r, or for what fell in the other way round) + the chart's own time,
    // see delay(); T counts from the camera's `from`; along: the affine parameter here, way_from_abreast() at a camera.
    struct Start {
        long double base, from;
        std::optional<long double> along{};
    };
    Path(const KerrChart& chart, const KerrLaunch& launch, const Start& start);
    KerrRay trace(int most_crossings, const KerrWatch& watch);

private:
    // Where a step begins, with what is needed to go on from there.
    struct Here {
        KerrLine line;
        KerrState state{};
        Vec3 x, velocity;
        double azimuth = 0;  // in the chart, windings kept
        // the affine parameter; the chart's time since the start, but for what `state` has of it
        long double along = 0, time = 0;
    };
    Vec3 velocity(const KerrPhase& s) const { return s.p + chart_.pull(sense_ * energy_, s.x, s.p).drift; }
    FehlbergStep<7> step(const Here& from, double lambda) const {
        const auto system = [&](const KerrState& s, KerrState& d, double l) {
            from.line.slope(chart_, sense_ * energy_, s, d, l);
        };
        return {system, from.state, lambda};
    }
    double longest_step(double r, bool timed) const {
        const bool outward = dot(here_.x, here_.velocity) > 0;
        return std::min(straight_step(r, kBending, outward && timed ? kLate : INFINITY), kLongestStep * r) /
               here_.line.speed;
    }
    KerrState stepped(const Here& from, double lambda) const { return step(from, lambda).end; }
    KerrPlace place_of(const Here& from, const KerrState& state, double lambda) const;
    using Between = HermiteNinth<4>;  // place and s[6]
    Between between(const KerrState& end, double taken) const;
    KerrGlance glance(const Between& between, double lambda, double taken, bool timed) const;
    void add_crossing(double taken, KerrRay& ray) const;
    void show(const KerrState& state, double taken, const KerrWatch& watch) const;
    void begin_line(const KerrLine& line, const KerrPhase& phase, double r);
    void go_on(const KerrState& state, double taken, const KerrPhase& phase, double r);
    double boyer_lindquist(double chart_azimuth, double r) const {
        return phi_ - sense_ * (chart_azimuth - chart_.ahead(r));
    }
    // The chart's t is v - r of what is traced: of the mirror image -t + r_* - r.
    double delay(const Here& from, double clock, double lambda, double r) const {
        const long double passed = from.time + static_cast<long double>(energy_) * lambda;
        return static_cast<double>(start_.base + passed) + sense_ * (clock / kClockUnit - chart_.tortoise_ahead(r));
    }
    double delay(const Here& from, const KerrState& s, double lambda, double r) const {
        return delay(from, s[6], lambda, r);
    }
    bool is_far(double r) const;
    double delay_from(double r) const;
    void follow_mirrored(const KerrPhase& phase, double r, int most_crossings, const KerrWatch& watch,
                         KerrRay& ray) const;
    void reach_sky(KerrRay& ray) const;

    KerrChart chart_;
    Start start_;
    double outer_, phi_, energy_, momentum_, scale_;
    double sense_;  // 1: the mirror image, forward; -1: the photon itself, backward
    bool stays_ = false;
    long double lead_ = 0;  // of the time over the way along the line, where that is counted from the foot
    double excess_ = 0;     // speed - energy of the line
    Here here_;
};

Path::Path(const KerrChart& chart, const KerrLaunch& launch, const Start& start)
    : chart_(chart),
      start_(start),
      outer_(chart.outer()),
      phi_(launch.phi),
      energy_(launch.energy),
      momentum_(launch.l_over_sine * std::sin(launch.theta)),
      scale_(std::max(1.0, launch.r)),
      sense_(launch.sense()) {
    const KerrBeginning from = beginning(chart, launch);
    here_.x = from.phase.x, here_.velocity = velocity(from.phase), here_.azimuth = from.azimuth;
    begin_line(from.line, from.phase, launch.r);
    here_.along = start.along.value_or(way_from_abreast(chart, launch));
    stays_ = here_.x.z == 0 && std::abs(launch.p_theta) < kStaysThere * std::abs(energy_);
}

void Path::begin_line(const KerrLine& line, const KerrPhase& phase, double r) {
    here_.line = line;
    here_.state = {};
    here_.line.weigh(r, here_.state);
    lead_ = here_.time - line.begin;
    const KerrChart::Pull pull = chart_.pull(sense_ * energy_, phase.x, phase.p);
    excess_ = pull.delay * pull.lp / (line.speed + energy_);  // p^2 = E^2 + 2 H (l p)^2
}

// On to where a step has come.
void Path::go_on(const KerrState& state, double taken, const KerrPhase& phase, double r) {
    const Vec3 before = here_.x, motion = here_.velocity;
    here_.x = phase.x, here_.velocity = velocity(phase), here_.state = state;
    here_.azimuth += turned(here_.azimuth, before, here_.x, motion);
    here_.along += taken;
    here_.time += static_cast<long double>(energy_) * taken;
    lead_ -= static_cast<long double>(excess_) * taken;
    if (state[0] * state[0] + state[1] * state[1] + state[2] * state[2] > kBent * kBent * r * r) {
        here_.time += sense_ * state[6] / kClockUnit;
        begin_line(KerrLine::of(phase), phase, r);
    } else {
        here_.line.begin += static_cast<long double>(here_.line.speed) * taken;
        here_.line.weigh(r, here_.state);
    }
}

// T, from far out on the way to the sky: delay + from - r_*, without the difference of |x| and r, and what is left of a
// straight way. On the line |x| is the way from the foot but for what is across, and energy lambda is that way but for
// `excess_`.
double Path::delay_from(double r) const {
    const Vec3 delta{here_.state[0], here_.state[1], here_.state[2]}, &x = here_.x, &n = here_.line.n;
    const double forth = dot(n, delta), off = length(here_.line.foot + delta - forth * n);
    const double far = length(x), on = static_cast<double>(here_.line.begin) + forth;
    const double passed = sense_ * here_.state[6] / kClockUnit - forth - off * off / (far + on);
    const double b = length(cross(x, here_.velocity)) / length(here_.velocity),
                 rest = b * b / (far + std::sqrt((far - b) * (far + b)));
    return static_cast<double>(start_.base + start_.from + lead_ +
                               (passed - (sense_ > 0 ? 2 * chart_.tortoise_ahead(r) : 0) + rest));
}

bool Path::is_far(double r) const {
    if (!(r > kFarForTime && dot(here_.x, here_.velocity) > 0)) return false;
    return r * length(here_.velocity) > kFarForTime * length(cross(here_.x, here_.velocity));
}

// The azimuth is counted from where the step began.
KerrPlace Path::place_of(const Here& from, const KerrState& state, double lambda) const {
    const Vec3 x = from.line.at(state, lambda).x;
    const double r = chart_.radius(x), flat = std::hypot(x.x, x.y) / std::sqrt(r * r + chart_.a * chart_.a);
    const double phi = boyer_lindquist(from.azimuth + turned(from.azimuth, from.x, x, from.velocity), r);
    return {r, std::atan2(flat, x.z / r), phi, delay(from, state, lambda, r)};
}

Path::Between Path::between(const KerrState& end, double taken) const {
    std::array<Between::Known, Between::kPlaces> known{};
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double lambda = Between::kAt[i] * taken;
        const KerrState state = i == 0 ? here_.state : i + 1 == known.size() ? end : stepped(here_, lambda);
        const auto [x, p] = here_.line.at(state, lambda);
        const KerrChart::Pull pull = chart_.pull(sense_ * energy_, x, p);
        const Vec3 motion = p + pull.drift;
        known[i] = {{x.x, x.y, x.z, state[6]},
                    {taken * motion.x, taken * motion.y, taken * motion.z, taken * kClockUnit * pull.delay}};
    }
    return Between(known);
}

// sin(theta) e^{i(phi~ - ...)} by (x + iy)/(r + ia), without angles.
KerrGlance Path::glance(const Between& between, double lambda, double taken, bool timed) const {
    const auto [value, slope] = between(lambda / taken);
    const Vec3 x{value[0], value[1], value[2]}, motion = Vec3{slope[0], slope[1], slope[2]} / taken;
    const double r = chart_.radius(x), a = chart_.a, across = r * r + a * a, cosine = x.z / r;
    const double co = (r * x.x + a * x.y) / across, si = (r * x.y - a * x.x) / across,
                 sine = std::sqrt(co * co + si * si);
    const double turn = phi_ + sense_ * chart_.drag_ahead(r), ct = std::cos(turn), st = std::sin(turn);
    const double rising = chart_.rising(x, motion);
    return {r,
            {ct * co + sense_ * st * si, st * co - sense_ * ct * si, cosine},
            timed ? delay(here_, value[3], lambda, r) : 0,
            rising,
            (cosine * rising - motion.z) / (r * std::max(sine, kAxis))};
}

// What of a step is outside the horizon.
void Path::show(const KerrState& state, double taken, const KerrWatch& watch) const {
    const auto outside = [this](const KerrState& s, double lambda) {
        return chart_.radius(here_.line.at(s, lambda).x) > outer_ * (1 + kAboveHorizon);
    };
    const bool begins = outside(here_.state, 0), ends = outside(state, taken);
    if (!begins && !ends) return;
    const double from = static_cast<double>(here_.along);
    const auto at = [this, here = here_, from](double along) {
        return place_of(here, stepped(here, along - from), along - from);
    };
    std::optional<Between> between_ends;
    const auto glanced = [&](double along, bool timed) {
        if (!between_ends) between_ends = between(state, taken);
        return glance(*between_ends, along - from, taken, timed);
    };
    KerrStep step{from, from + taken, {}, {}, at, std::ref(glanced)};
    if (begins != ends) {
        double out = begins ? 0 : taken, in = taken - out;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (out + in);
            (outside(stepped(here_, middle), middle) ? out : in) = middle;
        }
        (begins ? step.to : step.from) = from + out;
    }
    step.begin = begins ? place_of(here_, here_.state, 0) : at(step.from);
    step.end = ends ? place_of(here_, state, taken) : at(step.to);
    watch(step);
}

// The zero of z within the step: Newton's steps on its length, each taken whole from where the step began.
void Path::add_crossing(double taken, KerrRay& ray) const {
    double low = 0, high = taken, at = 0;
    KerrState state = here_.state;
    KerrPhase there{here_.x, here_.line.at(state, 0).p};
    for (int i = 0; i < 60; ++i) {
        double next = at - there.x.z / velocity(there).z;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double move = std::abs(next - at);
        at = next;
        state = stepped(here_, at);
        there = here_.line.at(state, at);
        ((there.x.z > 0) == (here_.x.z > 0) ? low : high) = at;
        if (move <= 1e-15 * std::abs(at) || there.x.z == 0) break;
    }
    const double r = chart_.radius(there.x);
    if (!(r > outer_)) return;
    const Vec3 motion = velocity(there);
    const double phi = boyer_lindquist(here_.azimuth + turned(here_.azimuth, here_.x, there.x, motion), r);
    // p^r = dr/dlambda of what is traced, with N sqrt(g_rr) = r/sqrt(g_phiphi); the photon's own has the other sign.
    const double climb = -chart_.rising(there.x, motion) * r / (energy_ * std::sqrt(chart_.g_phiphi(r)));
    ray.crossings.push_back({static_cast<double>(here_.along + at), r, phi, climb, delay(here_, state, at, r)});
}

// Of a photon that was traced as it is and has turned, on its way to the past horizon now.
void Path::follow_mirrored(const KerrPhase& phase, double r, int most_crossings, const KerrWatch& watch,
                           KerrRay& ray) const {
    const KerrLaunch launch = mirrored(chart_, phase, energy_, boyer_lindquist(here_.azimuth, r));
    const Start here{static_cast<long double>(delay(here_, here_.state, 0, r)) + chart_.tortoise_ahead(r), start_.from,
                     here_.along};
    const KerrRay rest = Path(chart_, launch, here).trace(most_crossings, watch);
    ray.crossings.insert(ray.crossings.end(), rest.crossings.begin(), rest.crossings.end());
    if (rest.fate == Fate::kEscaped)
        ray.fate = rest.fate, ray.sky = rest.sky, ray.phi_inf = rest.phi_inf, ray.delay = rest.delay;
}

// The motion's direction, nearer to the sky's than the place's.
void Path::reach_sky(KerrRay& ray) const {
    const Vec3 &x = here_.x, &motion = here_.velocity;
    ray.fate = Fate::kEscaped;
    const double to_motion = std::remainder(std::atan2(motion.y, motion.x) - std::atan2(x.y, x.x), 2 * M_PI);
    ray.phi_inf = phi_ - sense_ * (here_.azimuth + to_motion);
    const double flat = std::hypot(motion.x, motion.y), all = std::hypot(flat, motion.z);
    ray.sky = {flat / all * std::cos(ray.phi_inf), flat / all * std::sin(ray.phi_inf), motion.z / all};
}

KerrRay Path::trace(int most_crossings, const KerrWatch& watch) {
    KerrRay ray;
    ray.energy = energy_;
    ray.l_z = momentum_ / energy_;
    double r = chart_.radius(here_.x);
    bool outside = r > outer_;
    ray.fate = outside ? Fate::kCaptured : Fate::kNoSky;
    // From inside, what does not come out through this horizon: E (r_+^2 + a^2) <= a L.
    if (!outside && !(energy_ * chart_.horizon_area(outer_) > chart_.a * momentum_)) return ray;
    const double sky = std::max(kSky, 1e6 * scale_);
    double length = 0.01 * scale_;
    for (int i = 0; i < kMostSteps; ++i) {
        length = std::min(length, longest_step(r, std::isnan(ray.delay)));
        const double taken = length;
        const auto [state, error] = step(here_, taken);
        length *= next_fehlberg(error / kStepTolerance);
        if (error > kStepTolerance) continue;
        const KerrPhase phase = here_.line.at(state, taken);
        if (watch) show(state, taken, watch);
        const bool crossed = here_.x.z != 0 && (here_.x.z > 0) != (phase.x.z > 0) && !stays_;
        if (crossed && static_cast<int>(ray.crossings.size()) < most_crossings) add_crossing(taken, ray);
        r = chart_.radius(phase.x);
        if (r <= outer_ && outside) return ray;
        outside = outside || r > outer_;
        go_on(state, taken, phase, r);
        if (sense_ < 0 && outside && chart_.rising(phase.x, here_.velocity) < 0) {
            follow_mirrored(phase, r, most_crossings - static_cast<int>(ray.crossings.size()), watch, ray);
            return ray;
        }
        if (outside && std::isnan(ray.delay) && is_far(r)) ray.delay = delay_from(r);
        if (r < sky) continue;
        reach_sky(ray);
        return ray;
    }
    return ray;  // still winding: closer to the critical ray than a double can tell
}

}  // namespace

Vec3 KerrPlace::flat() const {
    return r * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double way_between(const KerrPlace& from, const KerrPlace& to) {
    const double sine = std::max(std::sin(from.theta), std::sin(to.theta));
    return std::hypot(to.r - from.r,
                      std::max(from.r, to.r) * std::hypot(to.theta - from.theta, sine * (to.phi - from.phi)));
}

KerrRay trace_kerr(const KerrHole& hole, const KerrStart& start, int most_crossings, const KerrWatch& watch) {
    const KerrChart chart{hole};
    const long double ahead = chart.tortoise_ahead(start.r);
    return Path(chart, kerr_launch(chart, start), {ahead, start.r + ahead}).trace(most_crossings, watch);
}

KerrRay trace_kerr(const KerrHole& hole, const KerrPhoton& photon, int most_crossings, bool falls,
                   const KerrWatch& watch) {
    const KerrChart chart{hole};
    const KerrLaunch launch = kerr_launch(chart, photon);
    // delay = 0 at the camera, or r_* - r; inside the horizon what is traced fell in, and r_* is not asked for.
    const long double sense = launch.sense(), ahead = falls && launch.falls ? 0 : chart.tortoise_ahead(photon.r);
    return Path(chart, launch, {falls ? ahead + sense * ahead : sense * ahead, photon.r + (falls ? 0 : ahead)})
        .trace(most_crossings, watch);
}

double kerr_azimuth_ahead(const KerrHole& hole, double r) {
    const KerrChart chart{hole};
    return chart.ahead(r) - std::atan2(chart.a, r);
}

}  // namespace nullscope::reference
