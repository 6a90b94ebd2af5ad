// Orbits about Janis, Newman and Winicour's mass: with x = r_g/r, y = 1 - x, qg = q r_g, (dx/dphi)^2 = y^(2 - 2g) P, P = qg^2 - W,
// W = x^2 y^(2g - 1). Integrals over x itself, or over s with x = x_t -+ s^2 about a turning point, or over ln(y) on the way into the
// singular surface, by Gauss-Kronrod panels halved until nothing changes, in long double.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "reference/plane_metrics.h"

namespace nullscope::reference {
namespace {

constexpr double kRadialQ = 1e30, kLeastQ = 1e-60;
// Of the first estimate of the whole, as the 10-point rule's error in a panel; the 21-point rule, which is taken, has a rounding.
constexpr Long kTolerance = 1e-13L;
constexpr int kDeepest = 40;

struct Panel {
    Long value, error;
};
template <class F>
Panel panel(const F& f, Long low, Long high) {
    const Long middle = (low + high) / 2, half = (high - low) / 2;
    Long error = 0;
    const Long value = boost::math::quadrature::gauss_kronrod<Long, 21>::integrate(
        [&](Long t) { return f(middle + half * t); }, Long(-1), Long(1), 0, Long(0), &error);
    return {half * value, half * error};
}
// Boost's own halving asks each half for half the error, below the last digit where an end is singular.
template <class F>
Long halved(const F& f, Long low, Long high, const Panel& whole, Long tolerance, int depth) {
    if (!(whole.error > tolerance) || depth == kDeepest) return whole.value;
    const Long middle = (low + high) / 2;
    return halved(f, low, middle, panel(f, low, middle), tolerance, depth + 1) +
           halved(f, middle, high, panel(f, middle, high), tolerance, depth + 1);
}
template <class F>
Long integral(const F& f, Long low, Long high) {
    if (!(high > low)) return 0;
    const Panel whole = panel(f, low, high);
    return halved(f, low, high, whole, kTolerance * std::abs(whole.value), 0);
}

struct Mass {
    Long g, r_g, x_c, w_c;
    explicit Mass(double gamma) : g(gamma), r_g(1 / g), x_c(2 / (1 + 2 * g)), w_c(w(x_c, 1 - x_c)) {}
    Long w(Long x, Long y) const { return x * x * std::pow(y, 2 * g - 1); }
    // W(from) - W(from + step), as far as their logarithms differ.
    Long fall(Long from, Long step) const {
        return -w(from, 1 - from) *
               std::expm1(2 * std::log1p(step / from) + (2 * g - 1) * std::log1p(-step / (1 - from)));
    }
    Long lapse2(Long r) const { return std::pow((r - r_g) / r, g); }
    Long area(Long r) const { return r * std::pow((r - r_g) / r, (1 - g) / 2); }
};

struct Start {  // qg; x, y = 1 - x; s = +1 inward; root_p = sqrt(P), delta2 = qg^2 - W_c
    Long q, x, y;
    int s;
    Long root_p, delta2;
};

class Ray : public Orbit {
public:
    Ray(const Mass& m, const Start& start) : m_(m), start_(start), turns_(start.delta2 < 0), outside_(start.x < m.x_c) {
        if (turns_) find_turn();
        const bool meets_turn = turns_ && outside_ == (start.s > 0);
        fate_ = turns_ ? (outside_ ? Fate::kEscaped : Fate::kCaptured) : start.s < 0 ? Fate::kEscaped : Fate::kCaptured;
        if (meets_turn) {
            turn_ = static_cast<double>(turn_x_ / m.r_g);
            turn_angle_ = static_cast<double>(to_turn(start.x, camera_t_));
        }
        rest_ = end_sweep(start.x, start.y, camera_t_);
        angle_ = static_cast<double>(rest_ + (meets_turn ? 2 * Long(turn_angle_) : 0));
    }
    double zeta_at(double angle) const override {
        if (angle == 0) return static_cast<double>(start_.x / m_.r_g);
        if (has_ended(angle)) return kNotANumber;
        const bool before = turn_ == turn_ && angle < turn_angle_;
        // Bracketed in x: what is left to sweep falls along the way out and grows along the way in.
        const auto left = [&](double x) {
            const Long t = turns_ ? std::abs(Long(x) - turn_x_) : 0;
            if (before) return static_cast<double>(to_turn(x, t)) - (turn_angle_ - angle);
            return static_cast<double>(end_sweep(x, 1 - Long(x), t)) - (angle_ - angle);
        };
        double low = 0, high = 1;
        if (turns_) (outside_ ? high : low) = static_cast<double>(turn_x_);
        if (before || turn_ != turn_) (start_.s > 0 ? low : high) = static_cast<double>(start_.x);
        if (before) (start_.s > 0 ? high : low) = static_cast<double>(turn_x_);
        const double at_low = left(low), at_high = left(high);
        if (at_low * at_high >= 0)
            return (std::abs(at_low) < std::abs(at_high) ? low : high) / static_cast<double>(m_.r_g);
        std::uintmax_t steps = 200;
        const auto found = boost::math::tools::toms748_solve(left, low, high, at_low, at_high,
                                                             boost::math::tools::eps_tolerance<double>(52), steps);
        return 0.5 * (found.first + found.second) / static_cast<double>(m_.r_g);
    }
    // T in r_s/c: R^2 = r_g^2 y^(1-g)/x^2, A R^2 dphi... : outward dT = dphi r_g ... / (q + sqrt P), inward q dphi/(x^2 y^(2g-1)).
    double delay() const override {
        if (fate_ != Fate::kEscaped) return kNotANumber;
        const auto out = [this](Long root_p, Long y) { return std::pow(y, 1 - m_.g) / (start_.q + root_p); };
        const Long leave = sky_leg(start_.x, camera_t_, out);
        if (!turns_ || start_.s < 0) return static_cast<double>(m_.r_g * leave);
        const auto both = [this](Long x, Long y) { return start_.q * std::pow(y, 1 - m_.g) / m_.w(x, y); };
        // 2 q/W from the camera to the turning point; in ln(x) far from it.
        const Long split = std::min(turn_x_ / 2, start_.x > turn_x_ / 2 ? Long(0) : turn_x_ / 2);
        Long in = 0;
        const Long near_t = split > 0 ? turn_x_ - split : camera_t_;
        in += about_turn(0, std::sqrt(near_t), both);
        if (split > 0)
            in += integral(
                [&](Long l) {
                    const Long x = std::exp(l), y = 1 - x;
                    return x * both(x, y) * rate(x, y);
                },
                std::log(start_.x), std::log(split));
        return static_cast<double>(m_.r_g * (leave + 2 * in));
    }

private:
    Long p(Long x, Long y) const {
        if (x < m_.x_c / 2) {
            const Long root = std::sqrt(m_.w(x, y));
            return (start_.q - root) * (start_.q + root);
        }
        if (y < (1 - m_.x_c) / 2) return start_.q * start_.q - m_.w(x, y);
        return start_.delta2 + m_.fall(m_.x_c, x - m_.x_c);
    }
    Long rate(Long x, Long y) const { return std::pow(y, m_.g - 1) / std::sqrt(p(x, y)); }
    // Integral of dphi weight(x, y) over x = turn -+ s^2.
    template <class Weight>
    Long about_turn(Long from, Long to, const Weight& weight) const {
        const int side = outside_ ? -1 : 1;
        return integral(
            [&](Long s) {
                const Long t = s * s, x = turn_x_ + side * t, y = 1 - x;
                return 2 * std::pow(y, m_.g - 1) / std::sqrt(m_.fall(turn_x_, side * t) / t) * weight(x, y);
            },
            from, to);
    }
    Long to_turn(Long, Long t) const {
        return about_turn(0, std::sqrt(t), [](Long, Long) { return Long(1); });
    }
    // From the sky to x, of dphi weight(sqrt P, y).
    template <class Weight>
    Long sky_leg(Long x, Long t, const Weight& weight) const {
        const auto direct = [&](Long z) {
            const Long y = 1 - z;
            return rate(z, y) * weight(std::sqrt(p(z, y)), y);
        };
        const Long near = turns_ ? std::min(x, turn_x_ / 4) : x;
        const Long first = integral(direct, 0, near);
        if (!turns_ || near == x) return first;
        return first + about_turn(std::sqrt(t), std::sqrt(turn_x_ - near),
                                  [&](Long z, Long y) { return weight(std::sqrt(p_of(z)), y); });
    }
    Long p_of(Long x) const { return std::max(m_.fall(turn_x_, x - turn_x_), Long(0)); }
    // What a ray at x still sweeps once it is past its turning point: to the sky, or to the singular surface.
    Long end_sweep(Long x, Long y, Long t) const {
        if (fate_ == Fate::kEscaped) return sky_leg(x, t, [](Long, Long) { return Long(1); });
        const Long middle = std::max((1 + (turns_ ? turn_x_ : m_.x_c)) / 2, x);
        Long sum = 0;
        if (x < middle)
            sum = turns_ ? about_turn(std::sqrt(t), std::sqrt(middle - turn_x_), [](Long, Long) { return Long(1); })
                         : integral([this](Long z) { return rate(z, 1 - z); }, x, middle);
        const Long y1 = x < middle ? 1 - middle : y;  // y = y1 exp(-tau)
        return sum + integral(
                         [&](Long tau) {
                             const Long z = y1 * std::exp(-tau);
                             return std::pow(z, m_.g) / std::sqrt(start_.q * start_.q - m_.w(1 - z, z));
                         },
                         0, 50 / m_.g);
    }
    // W(turn) = qg^2; from the camera where that is near, for the digits of their distance.
    void find_turn() {
        const int side = outside_ ? -1 : 1;
        Long low = 0, high = outside_ ? m_.x_c : 1 - m_.x_c;  // distance from the photon sphere
        const auto beyond = [&](Long d) {                     // qg^2 < W: not yet
            const Long x = m_.x_c + side * d;
            return outside_ && x < m_.x_c / 2 ? p(x, 1 - x) > 0 : start_.delta2 + m_.fall(m_.x_c, side * d) > 0;
        };
        for (int i = 0; i < 200 && high - low > 1e-19L * high; ++i) {
            const Long middle = (low + high) / 2;
            (beyond(middle) ? high : low) = middle;
        }
        turn_x_ = m_.x_c + side * (low + high) / 2;
        if (outside_ && start_.q * start_.q < m_.w_c / 16) {  // far out x itself keeps the digits
            Long a = 0, b = m_.x_c / 2;
            for (int i = 0; i < 200 && b - a > 1e-19L * b; ++i) {
                const Long middle = (a + b) / 2;
                (p(middle, 1 - middle) > 0 ? a : b) = middle;
            }
            turn_x_ = (a + b) / 2;
        }
        camera_t_ = std::max(side * (start_.x - turn_x_), Long(0));
        // P = fall(t), t = root_p^2 t/fall(t): keeps the digits that x - turn has lost.
        for (int i = 0; i < 40 && camera_t_ < Long(0.05) * std::min(turn_x_, 1 - turn_x_); ++i) {
            const Long step = std::max(camera_t_, Long(1e-15L) * turn_x_);
            camera_t_ = start_.root_p * start_.root_p * step / m_.fall(turn_x_, side * step);
        }
    }
    Mass m_;
    Start start_;
    bool turns_, outside_;
    Long turn_x_ = 0, camera_t_ = 0, rest_ = 0;
};

class Jnw : public OrbitMetric {
public:
    explicit Jnw(double gamma) : m_(gamma) {}
    std::optional<double> horizon_radius() const override { return static_cast<double>(m_.r_g); }
    double lapse(double r) const override { return std::sqrt(static_cast<double>(m_.lapse2(r))); }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const Long q = std::max(ray.q, kLeastQ) * m_.r_g, x = ray.zeta0 * m_.r_g, y = 1 - x;
        if (!(y > 0)) return bad_input(fmt::format("zeta0 = {} lies on or within the singular surface", ray.zeta0));
        const Long root = std::sqrt(m_.w(x, y)), p = ray.q < kRadialQ ? (q - root) * (q + root) : 0;
        if (p < -kTurningSlack * q * q) return no_such_ray(ray, "zeta0", ": q^2 < V(zeta0)");
        return orbit(
            {q, x, y, ray.s, std::sqrt(std::max(p, Long(0))), (q - std::sqrt(m_.w_c)) * (q + std::sqrt(m_.w_c))});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long q = std::sqrt(m_.lapse2(ray.r)) / m_.area(ray.r) / ray.n_t;
        return local(ray.r, q, q * std::abs(ray.n_r), ray.n_r <= 0 ? 1 : -1);
    }
    RainOrbit from_rain(const LocalRay& ray) const override {  // E = 1 + w n_r, dr ~ w + n_r, w = sqrt(1 - A)
        if (!(ray.r > m_.r_g)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        const Long w = std::sqrt(1 - m_.lapse2(ray.r)), energy = 1 + w * ray.n_r, outward = w + ray.n_r,
                   across = m_.area(ray.r) * ray.n_t;
        return {local(ray.r, energy / across, std::abs(outward) / across, outward > 0 ? -1 : 1),
                static_cast<double>(1 / energy)};
    }

private:
    std::unique_ptr<Orbit> local(Long r, Long q, Long root_p, int s) const {
        Start start{q * m_.r_g, m_.r_g / r, (r - m_.r_g) / r, s, root_p * m_.r_g, 0};
        const Long off = start.x - m_.x_c, root = std::sqrt(m_.w_c);
        start.delta2 = std::abs(off) < m_.x_c / 4 && start.y > (1 - m_.x_c) / 4
                           ? start.root_p * start.root_p - m_.fall(m_.x_c, off)
                           : (start.q - root) * (start.q + root);
        return orbit(start);
    }
    std::unique_ptr<Orbit> orbit(Start start) const {
        const double zeta0 = static_cast<double>(start.x / m_.r_g);
        if (!(start.q < kRadialQ))
            return std::make_unique<StandingOrbit>(zeta0, start.s < 0 ? Fate::kEscaped : Fate::kCaptured, true);
        if (start.delta2 == 0) {
            if (start.root_p == 0) return std::make_unique<StandingOrbit>(zeta0, Fate::kNoSky, false);
            start.delta2 = std::pow(Long(std::numeric_limits<double>::epsilon()), 2);
        }
        return std::make_unique<Ray>(m_, start);
    }
    Mass m_;
};

}  // namespace

OrbitMetricPtr make_janis_newman_winicour_orbits(const SpacetimeSpec& spec) {
    return std::make_unique<Jnw>(parameter_of(spec, "gamma", 0.8));
}

}  // namespace nullscope::reference
