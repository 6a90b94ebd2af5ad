// Where the ball of a scene is at a time t, found another way than observer/ball_motion.h: orbits by Kepler's law from
// differences of the metric, free fall by Hamilton's equations in t, with the momentum of the tortoise radius:
//     H = sqrt(P^2 + A (1 + L^2/r^2)),  dr/dt = A P/H,  dP/dt = -A (A (1 + L^2/r^2))'/(2 H),  dphi/dt = A L/(r^2 H).
// Nothing grows at the horizon, and no step is refused.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "expr/formula.h"
#include "reference/bodies.h"
#include "reference/kerr_between.h"
#include "reference/kerr_fall.h"
#include "reference/orbit.h"

namespace nullscope::reference {
namespace {

// A ball in free fall in its plane, forward and back from t = 0: what it went through is kept, as polynomials between its steps.
class Fall {
public:
    using State = std::array<double, 3>;  // r, P, phi
    Fall(const OrbitMetric& metric, State start, double momentum)
        : metric_(metric), horizon_(metric.horizon_radius().value_or(0.0)), momentum_(momentum) {
        for (Way& way : ways_) way.stretches.push_back(Stretch{start, 0, stretch_at(start[0])});
    }
    State at(double t) {
        const std::lock_guard lock(mutex_);
        if (std::fabs(t) <= kLong || !find_period(std::fabs(t))) return along(t);
        const double periods = std::floor(t / period_->time);
        State s = along(t - periods * period_->time);
        s[2] += periods * period_->angle;
        return s;
    }

private:
    using Between = HermiteNinth<3>;
    struct Stretch {
        State begin;
        double from, length;                       // |t|
        std::unique_ptr<const Between> between{};  // once it is asked for
        bool lands = false;                        // on a star: no polynomial
    };
    struct Way {
        std::vector<Stretch> stretches;
        bool still = false;  // r stays what it is in the last stretch: on a horizon, on a star, in a circle
        double rate = 0;     // d(phi)/d|t| there
    };
    struct Period {
        double time, angle;  // from one smallest radius to the next
    };
    static constexpr double kStep = 0.02;  // r_s/c: the shortest time in which anything happens outside is some r_s/c
    static constexpr double kStretch = 0.06;      // its places are at most a step apart
    static constexpr double kNear = 16;           // r_s: farther out both grow with the radius
    static constexpr double kLong = 1e4;          // r_s/c: later, a bound orbit is known by its period
    static constexpr std::size_t kMost = 400000;  // stretches in which a period is looked for

    static double stretch_at(double r) { return kStretch * std::max(1.0, r / kNear); }

    void extend(Way& way, double sense) const {
        const Stretch& last = way.stretches.back();
        const State end = stepped(last.begin, sense * last.length);
        way.still = end[0] == last.begin[0] && end[1] == last.begin[1];
        way.rate = (end[2] - last.begin[2]) / last.length;
        way.stretches.push_back(Stretch{end, last.from + last.length, stretch_at(end[0])});
    }
    State along(double t) {
        const double sense = t < 0 ? -1 : 1, time = std::fabs(t);
        Way& way = ways_[t < 0];
        while (!way.still && time >= way.stretches.back().from + way.stretches.back().length) extend(way, sense);
        if (const Stretch& last = way.stretches.back(); way.still && time >= last.from)
            return {last.begin[0], last.begin[1], last.begin[2] + way.rate * (time - last.from)};
        Stretch& stretch = *std::prev(std::ranges::upper_bound(way.stretches, time, {}, &Stretch::from));
        if (!stretch.between && !stretch.lands) look_between(stretch, sense);
        if (stretch.between) return (*stretch.between)((time - stretch.from) / stretch.length).value;
        return stepped(stretch.begin, sense * (time - stretch.from));
    }
    // Whether there is one that ends before `until`.
    bool find_period(double until) {
        Way& way = ways_[0];
        for (; !period_ && !way.still && searched_ < kMost && way.stretches[searched_].from < until; ++searched_) {
            if (way.stretches.size() < searched_ + 2) extend(way, 1);
            const Stretch& stretch = way.stretches[searched_];
            if (!(stretch.begin[1] < 0 && way.stretches[searched_ + 1].begin[1] >= 0)) continue;
            double inward = 0, outward = stretch.length;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (inward + outward);
                (stepped(stretch.begin, middle)[1] < 0 ? inward : outward) = middle;
            }
            const Period least{stretch.from + outward, stepped(stretch.begin, outward)[2]};
            if (least_) period_ = {least.time - least_->time, least.angle - least_->angle};
            least_ = least;
        }
        return period_.has_value();
    }

    void look_between(Stretch& stretch, double sense) const {
        std::array<Between::Known, Between::kPlaces> known;
        State next = stretch.begin;
        for (std::size_t i = 0; i < known.size(); ++i) {
            const double h = i > 0 ? sense * stretch.length * (Between::kAt[i] - Between::kAt[i - 1]) : 0;
            const State before = std::exchange(next, after(next, h));
            if (!is_above(2 * next[0] - before[0])) stretch.lands = true;
            known[i].value = next;
            slope(next, known[i].slope);
            for (double& s : known[i].slope) s *= sense * stretch.length;
        }
        if (!stretch.lands) stretch.between = std::make_unique<const Between>(known);
    }
    State stepped(State s, double h) const {
        const double step = kStep / kStretch * stretch_at(s[0]);
        for (; std::fabs(h) > step; h -= std::copysign(step, h)) s = landed(s, std::copysign(step, h));
        return landed(s, h);
    }
    bool is_above(double r) const {
        constexpr double kGround = 1e-6;  // of r
        return std::isfinite(metric_.lapse(r * (1 - kGround))) || metric_.horizon_radius();
    }
    // A star's ground is where its lapse ends: the last step to it by halves.
    State landed(const State& s, double h) const {
        constexpr double kShortest = 1e-6;  // r_s/c
        if (!is_above(s[0])) return s;
        const State next = after(s, h);
        if (is_above(2 * next[0] - s[0]) || std::fabs(h) < kShortest) return next;
        return landed(landed(s, h / 2), h / 2);
    }
    State after(State s, double h) const {
        boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
        stepper.do_step([this](const State& x, State& d, double) { slope(x, d); }, s, 0.0, h);
        return s;
    }
    void slope(const State& s, State& d) const {
        constexpr double kThere = 1e-12;  // of the horizon: nearer to it A is rounding
        const double r = s[0];
        d = {0, 0, 0};
        if (!(r > horizon_ * (1 + kThere))) return;
        const double a = metric_.lapse2(r);
        if (!(a > 0)) return;  // on a star's ground
        const double across = momentum_ / r, energy = std::sqrt(s[1] * s[1] + a * (1 + across * across));
        d[0] = a * s[1] / energy;
        d[1] = -a * (metric_.lapse2_slope(r) * (1 + across * across) - 2 * a * across * across / r) / (2 * energy);
        d[2] = a * across / (r * energy);
    }
    const OrbitMetric& metric_;
    double horizon_, momentum_;
    std::array<Way, 2> ways_;  // forward and back
    std::size_t searched_ = 0;
    std::optional<Period> least_, period_;  // the first smallest radius: since the start
    std::mutex mutex_;
};

}  // namespace

std::function<Vec3(double t)> ball_way(const Metric& metric, const BallSpec& ball) {
    const Vec3 start = ball.position;
    const double r = length(start), azimuth = std::atan2(start.y, start.x);
    const Vec3 e_r = start / r, e_phi{-std::sin(azimuth), std::cos(azimuth), 0};
    const auto turned = [=](Vec3 onward, double radius, double phi) {
        return radius * (std::cos(phi) * e_r + std::sin(phi) * onward);
    };
    switch (ball.motion) {
        case BallMotion::kStill: break;
        case BallMotion::kOrbit:
            return [=, omega = metric.kepler_rate(r, metric.sense(ball.sense))](double t) {
                return turned(e_phi, r, omega * t);
            };
        case BallMotion::kGeodesic: {
            if (metric.orbits() == nullptr) return kerr_fall(metric, start, ball.velocity);
            // velocity: (e_r, e_theta, e_phi) of one at rest there; E = gamma sqrt(A), P = A p_r = gamma v_r sqrt(A).
            const Vec3 v = ball.velocity, e_theta = cross(e_phi, e_r), across = v.y * e_theta + v.z * e_phi;
            const OrbitMetric& round = *metric.orbits();
            if (round.lapse(1e6) == 1) return [=, v = v.x * e_r + across](double t) { return start + t * v; };  // flat
            const double gamma = 1 / std::sqrt(1 - dot(v, v)), speed = length(across);
            const auto fall =
                std::make_shared<Fall>(round, Fall::State{r, gamma * v.x * round.lapse(r), 0}, gamma * speed * r);
            return [=, onward = speed > 0 ? across / speed : e_phi](double t) {
                const Fall::State s = fall->at(t);
                return turned(onward, s[0], s[2]);
            };
        }
        case BallMotion::kPath: {
            const auto x = expr::Formula::parse(ball.x, {"t"}), y = expr::Formula::parse(ball.y, {"t"}),
                       z = expr::Formula::parse(ball.z, {"t"});
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
