// Boost 1.74 copies a stepper's scratch space before its first use, and gcc says so at the place of the copy: here.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include "proof/kerr_schild.h"

#include <array>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

namespace nullscope::proof {
namespace {

namespace odeint = boost::numeric::odeint;

// x, y, z, p_x, p_y, p_z and v, the advanced time. p_t is a constant of the motion.
using State = std::array<Long, 7>;
using Stepper = odeint::runge_kutta_fehlberg78<State, Long>;

constexpr Long kPi = 3.14159265358979323846264338327950288L;
constexpr Long kFar = 1e12L;       // times the larger of camera radius and r_s: what is left of the bending is kFar^-2
constexpr Long kSwitch = 1.25L;    // where a ray that came out of the horizon changes to the other chart
constexpr Long kDeep = 0.02L;      // a ray from inside that falls this far has no sky
constexpr Long kNothing = 1e-20L;  // the absolute tolerance: a component that vanishes need not keep its digits
constexpr int kMostSteps = 100000;

LongVec operator+(LongVec a, LongVec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
LongVec operator*(Long s, LongVec a) { return {s * a.x, s * a.y, s * a.z}; }
Long dot(LongVec a, LongVec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
LongVec cross(LongVec a, LongVec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Long length(LongVec a) { return std::sqrt(dot(a, a)); }
LongVec unit(LongVec a) { return (1 / length(a)) * a; }
LongVec place_of(const State& s) { return {s[0], s[1], s[2]}; }
LongVec momentum_of(const State& s) { return {s[3], s[4], s[5]}; }

// H = (p^2 - p_t^2 - f (l.p)^2)/2 with l^mu = (-1, e x/r), l.p = -p_t + e x.p/r =: -w. The parameter is scaled by r/(|p| + |p_t|),
// so that a step is a fraction of the radius everywhere.
struct Equations {
    KerrSchildMetric metric;
    Long energy;  // p_t
    int chart;    // e
    bool outward = false;
    Long f(Long r) const { return (metric.mass - metric.charge2 / r) / r; }
    void operator()(const State& s, State& d, Long) const {
        const LongVec x = place_of(s), p = momentum_of(s);
        const Long r = length(x);
        const LongVec out = (1 / r) * x;
        const Long f = this->f(r), slope = (-metric.mass + 2 * metric.charge2 / r) / (r * r);
        const Long along = dot(out, p), l = chart * along - energy;
        const LongVec velocity = p + (-f * l * chart) * out, sideways = p + (-along) * out;
        // grad(l) = e sideways / r
        const LongVec force = (0.5L * slope * l * l) * out + (f * l * chart / r) * sideways;
        const Long scale = r / (length(p) + std::fabs(energy)), rising = dot(out, velocity);
        // p_t = -A v' + r' and v' (2 r' - A v') = -(|x cross p|/r)^2: v' from the one or the other, whichever does not cancel. One of them
        // for a whole step: between its stages, where H = 0 holds only roughly, they differ.
        const Long advanced = outward ? -dot(sideways, sideways) / (energy + rising) : (rising - energy) / (1 - f);
        d = {scale * velocity.x, scale * velocity.y, scale * velocity.z, scale * force.x,
             scale * force.y,    scale * force.z,    scale * advanced};
    }
};

class Tracer {
public:
    Tracer(const KerrSchildMetric& metric, const LongQuery& query, int crossings, Long tolerance)
        : equations_{metric, 0, -1, false}, most_crossings_(crossings), tolerance_(tolerance) {
        start(query);
    }
    IntegratedRay run() {
        if (equations_.energy <= 0) return ray_;  // light of no positive energy came from no sky
        odeint::controlled_runge_kutta<Stepper> stepper(
            odeint::default_error_checker<Long, odeint::array_algebra, odeint::default_operations>(kNothing,
                                                                                                   tolerance_));
        Long time = 0, h = 0.01L;
        for (int step = 0; step < kMostSteps; ++step) {
            const State before = state_;
            const Long started = time;
            State rate;
            equations_(before, rate, 0);
            equations_.outward = rate[0] * before[0] + rate[1] * before[1] + rate[2] * before[2] > 0;
            while (stepper.try_step(std::cref(equations_), state_, time, h) == odeint::fail) {
            }
            ray_.steps = step + 1;
            if (find_end(before, time - started)) break;
        }
        return ray_;
    }

private:
    void start(const LongQuery& query) {
        // A camera on the equator to the last digits of a double is on it: what lies behind it is not its first crossing.
        const bool equator = std::fabs(std::cos(query.theta)) < 1e-12L;
        const Long st = std::sin(query.theta), ct = equator ? 0 : std::cos(query.theta), sp = std::sin(query.phi),
                   cp = std::cos(query.phi);
        radial_ = {st * cp, st * sp, ct};
        const LongVec south{ct * cp, ct * sp, -st}, east{-sp, cp, 0};
        const Long r = 1 + query.r_minus_1;
        const LongVec n = unit(query.n);
        const Long across = std::sqrt(n.y * n.y + n.z * n.z);
        const LongVec sideways = across > 0 ? (1 / across) * (n.y * south + n.z * east) : -1 * south;
        const Long f = equations_.f(r);
        const Long a = equations_.metric.mass == 1 && equations_.metric.charge2 == 0 ? query.r_minus_1 / r : 1 - f;
        Long outward = n.x, aside = across, radial = 0;
        const bool came_in = std::sqrt(std::max(f, Long(0))) + outward > 0;
        if (query.frame == LocalFrame::kRain && (a <= 0 || (came_in && r < kSwitch && f > 0))) {
            // Regular on the horizon, which a ray that goes outward has crossed or may have come close to. The raindrop's momentum p = e_0 - n in the ingoing chart, w = sqrt(f): see the Gullstrand-Painleve form.
            const Long w = std::sqrt(f);
            equations_.chart = 1;
            equations_.energy = 1 + w * outward;
            radial = w + outward + f * (outward - 1) / (1 + w);
            inside_ = a <= 0;
        } else {
            if (query.frame == LocalFrame::kRain) {  // the static observer sees the raindrop's sky aberrated
                const Long w = std::sqrt(f), seen = 1 + w * outward;
                aside *= std::sqrt(a) / seen;
                outward = (outward + w) / seen;
            }
            equations_.energy = a;  // all components times sqrt(A)
            radial = outward - equations_.chart * f;
            aside *= std::sqrt(a);
        }
        // A past-directed ray has energy p_t > 0.
        const LongVec x = r * radial_, p = radial * radial_ + aside * sideways;
        state_ = {x.x, x.y, x.z, p.x, p.y, p.z, 0};
        sideways_ = sideways;
        start_r_ = r;
        const Long mass = equations_.metric.mass;
        horizon_ = mass == 0 ? 0 : (mass + std::sqrt(mass * mass - 4 * equations_.metric.charge2)) / 2;
    }
    Long swept(LongVec where) const {
        const Long angle = std::atan2(dot(where, sideways_), dot(where, radial_));
        return angle + 2 * kPi * std::round((ray_.angle - angle) / (2 * kPi));
    }
    State step_from(const State& before, Long h) const {
        State after = before;
        Stepper().do_step(std::cref(equations_), after, 0.0L, h);
        return after;
    }
    // The part of the step at which value(state) vanishes: a secant that keeps the root between its ends (Illinois).
    template <class Value>
    State crossing_state(const State& before, Long h, const Value& value) const {
        Long low = 0, high = h, at_low = value(before), at_high = value(step_from(before, h));
        int side = 0;
        State middle = before;
        for (int i = 0; i < 80 && std::fabs(high - low) > 4e-19L * h; ++i) {
            const Long guess = (low * at_high - high * at_low) / (at_high - at_low);
            middle = step_from(before, guess);
            const Long here = value(middle);
            if (here == 0) break;
            if ((here > 0) == (at_high > 0)) {
                high = guess, at_high = here;
                if (side == 1) at_low /= 2;
                side = 1;
            } else {
                low = guess, at_low = here;
                if (side == -1) at_high /= 2;
                side = -1;
            }
        }
        return middle;
    }
    void find_crossing(const State& before, Long h) {
        if (static_cast<int>(ray_.crossings.size()) >= most_crossings_ || before[2] == 0) return;
        if ((before[2] > 0) == (state_[2] > 0)) return;
        const State at = crossing_state(before, h, [](const State& s) { return s[2]; });
        const LongVec place = place_of(at);
        State rate;
        equations_(at, rate, 0);
        const LongVec velocity{rate[0], rate[1], rate[2]};
        const Long r = length(place), around = length(cross(place, velocity)) / r;
        ray_.crossings.push_back({swept(place), r, dot(place, velocity) / around, place});
    }
    // Advances the swept angle; true at the end of the ray.
    bool find_end(const State& before, Long h) {
        const LongVec place = place_of(state_);
        const Long r = length(place), r_before = length(place_of(before));
        const bool inward = dot(place, momentum_of(state_)) < 0;
        if (equations_.chart < 0 && r <= horizon_) {
            const State end = crossing_state(before, h, [&](const State& s) { return length(place_of(s)) - horizon_; });
            const bool planar_crossing_first = (before[2] > 0) != (end[2] > 0);
            if (planar_crossing_first) find_crossing(before, h);
            ray_.angle = swept(place_of(end));
            ray_.direction = unit(place_of(end));
            ray_.fate = inside_ ? Fate::kNoSky : Fate::kCaptured;
            return true;
        }
        find_crossing(before, h);
        ray_.angle = swept(place);
        if (inside_ && r < kDeep) return true;
        if (equations_.chart > 0 && (r > kSwitch || (r > horizon_ && r < r_before))) change_chart();
        if (r < kFar * std::max(start_r_, Long(1)) || inward) return false;
        ray_.fate = Fate::kEscaped;
        ray_.direction = unit(momentum_of(state_));
        ray_.angle = swept(ray_.direction);
        const Long impact = length(cross(place, momentum_of(state_))) / equations_.energy;
        ray_.delay = impact * impact / (2 * r) - state_[6];
        return true;
    }
    // p = p_t dt + p_r dr with dt_in = dt_out + 2 (1/A - 1) dr.
    void change_chart() {
        const LongVec place = place_of(state_);
        const Long r = length(place), f = equations_.f(r), more = 2 * equations_.energy * f / (1 - f) / r;
        state_[3] += more * place.x, state_[4] += more * place.y, state_[5] += more * place.z;
        equations_.chart = -1;
    }

    Equations equations_;
    int most_crossings_;
    Long tolerance_, start_r_ = 1, horizon_ = 1;
    bool inside_ = false;
    State state_{};
    LongVec radial_, sideways_;
    IntegratedRay ray_;
};

}  // namespace

LongQuery long_query(const RayQuery& q) {
    return {static_cast<Long>(q.r) - 1, q.theta, q.phi, {q.n.x, q.n.y, q.n.z}, q.frame};
}

std::optional<KerrSchildMetric> kerr_schild_metric(const SpacetimeSpec& spec) {
    if (spec.metric == "schwarzschild") return KerrSchildMetric{1, 0};
    if (spec.metric == "reissner-nordstrom") {
        const auto charge = spec.parameters.find("charge");
        const Long q = charge == spec.parameters.end() ? Long(0.5) : Long(charge->second);
        return KerrSchildMetric{1, q * q / 4};
    }
    if (spec.metric == "formula" && spec.parameters.formulas.empty()) return KerrSchildMetric{1, 0};  // 1 - 1/r
    if (spec.metric == "minkowski") return KerrSchildMetric{0, 0};
    return {};
}

IntegratedRay integrate(const KerrSchildMetric& metric, const LongQuery& query, int crossings, Long tolerance) {
    return Tracer(metric, query, crossings, tolerance).run();
}

}  // namespace nullscope::proof
