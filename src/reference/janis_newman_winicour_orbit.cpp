// Orbits about Janis, Newman and Winicour's mass: with x = r_g/r, y = 1 - x, qg = q r_g, (dx/dphi)^2 = y^(2 - 2g) P, P = qg^2 - W,
// W = x^2 y^(2g - 1). Integrals over x itself, or over s with x = x_t -+ s^2 about a turning point, or over ln(y) on the way into the
// singular surface, by Gauss-Kronrod panels halved until nothing changes, in long double.
#include <fmt/format.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "reference/potential_orbit.h"

namespace nullscope::reference {
namespace {

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
    Long sphere, q_crit, horizon;  // what is there is the singular surface
    explicit Mass(double gamma)
        : g(gamma),
          r_g(1 / g),
          x_c(2 / (1 + 2 * g)),
          w_c(w(x_c, 1 - x_c)),
          sphere(x_c / r_g),
          q_crit(std::sqrt(w_c) / r_g),
          horizon(1 / r_g) {}
    bool has_circle() const { return true; }
    Long w(Long x, Long y) const { return x * x * std::pow(y, 2 * g - 1); }
    // W(from) - W(from + step), as far as their logarithms differ.
    Long fall(Long from, Long step) const {
        return -w(from, 1 - from) *
               std::expm1(2 * std::log1p(step / from) + (2 * g - 1) * std::log1p(-step / (1 - from)));
    }
    Long lapse2(Long r) const { return std::pow((r - r_g) / r, g); }
    Long radius(Long r) const { return r * std::pow((r - r_g) / r, (1 - g) / 2); }
    Long fall_speed(Long r) const { return r > r_g ? std::sqrt(1 - lapse2(r)) : kNotANumber; }
    Long p(Long q, Long zeta) const {
        const Long root = std::sqrt(w(zeta * r_g, 1 - zeta * r_g)) / r_g;
        return (q - root) * (q + root);
    }
    Long below(Long zeta) const {  // as far as the singular surface, not a rounding beyond it
        return fall(x_c, std::min(zeta * r_g, 1 - x_c)) / (r_g * r_g);
    }
};

constexpr auto kOne = [](Long, Long) { return Long(1); };  // as a weight

class Ray : public Orbit {
public:
    Ray(const Mass& m, const PotentialStart& at)
        : Orbit(static_cast<double>(at.zeta0)),
          m_(m),
          start_{at.r, at.q * m.r_g, at.zeta0, at.s, at.root_p * m.r_g, at.delta2 * m.r_g * m.r_g, at.beyond},
          x_(at.zeta0 * m.r_g),
          turns_(at.delta2 < 0),
          outside_(x_ < m.x_c) {
        if (turns_) find_turn(at);
        const bool meets_turn = turns_ && outside_ == (at.s > 0);
        fate_ = (turns_ ? outside_ : at.s < 0) ? Fate::kEscaped : Fate::kCaptured;
        if (meets_turn) {
            turn_ = static_cast<double>(turn_x_ / m.r_g);
            turn_angle_ = static_cast<double>(to_turn(camera_t_));
        }
        const Long rest = end_sweep(x_, (at.r - m.r_g) / at.r, camera_t_);
        angle_ = static_cast<double>(rest + (meets_turn ? 2 * Long(turn_angle_) : 0));
    }
    // T in r_s/c: R^2 = r_g^2 y^(1-g)/x^2, A R^2 dphi... : outward dT = dphi r_g ... / (q + sqrt P), inward q dphi/(x^2 y^(2g-1)).
    double delay() const override {
        if (fate_ != Fate::kEscaped) return kNotANumber;
        const auto out = [this](Long root_p, Long y) { return std::pow(y, 1 - m_.g) / (start_.q + root_p); };
        const Long leave = sky_segment(x_, camera_t_, out);
        if (!turns_ || start_.s < 0) return static_cast<double>(m_.r_g * leave);
        const auto both = [this](Long x, Long y) { return start_.q * std::pow(y, 1 - m_.g) / m_.w(x, y); };
        // 2 q/W from the camera to the turning point; in ln(x) far from it.
        const Long split = std::min(turn_x_ / 2, x_ > turn_x_ / 2 ? Long(0) : turn_x_ / 2);
        Long in = 0;
        const Long near_t = split > 0 ? turn_x_ - split : camera_t_;
        in += about_turn(0, std::sqrt(near_t), both);
        if (split > 0)
            in += integral(
                [&](Long l) {
                    const Long x = std::exp(l), y = 1 - x;
                    return x * both(x, y) * rate(x, y);
                },
                std::log(x_), std::log(split));
        return static_cast<double>(m_.r_g * (leave + 2 * in));
    }

private:
    double place_at(double angle) const override {
        const bool before = turn_ == turn_ && angle < turn_angle_;
        // Bracketed in x: what is left to sweep falls along the way out and grows along the way in.
        const auto left = [&](double x) {
            const Long t = turns_ ? std::abs(Long(x) - turn_x_) : 0;
            if (before) return static_cast<double>(to_turn(t)) - (turn_angle_ - angle);
            return static_cast<double>(end_sweep(x, 1 - Long(x), t)) - (angle_ - angle);
        };
        double low = 0, high = 1;
        if (turns_) (outside_ ? high : low) = static_cast<double>(turn_x_);
        if (before || turn_ != turn_) (start_.s > 0 ? low : high) = static_cast<double>(x_);
        if (before) (start_.s > 0 ? high : low) = static_cast<double>(turn_x_);
        const double at_low = left(low), at_high = left(high);
        if (at_low * at_high >= 0)
            return (std::abs(at_low) < std::abs(at_high) ? low : high) / static_cast<double>(m_.r_g);
        return root_of(left, low, high, at_low, at_high, 52) / static_cast<double>(m_.r_g);
    }
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
    Long to_turn(Long t) const { return about_turn(0, std::sqrt(t), kOne); }
    // From the sky to x, of dphi weight(sqrt P, y).
    template <class Weight>
    Long sky_segment(Long x, Long t, const Weight& weight) const {
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
        if (fate_ == Fate::kEscaped) return sky_segment(x, t, kOne);
        const Long middle = std::max((1 + (turns_ ? turn_x_ : m_.x_c)) / 2, x);
        Long sum = 0;
        if (x < middle)
            sum = turns_ ? about_turn(std::sqrt(t), std::sqrt(middle - turn_x_), kOne)
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
    void find_turn(const PotentialStart& at) {
        const int side = outside_ ? -1 : 1;
        const Turn turn = turning_point(m_, at);
        turn_x_ = turn.zeta * m_.r_g;
        camera_t_ = m_.r_g * camera_distance(at, turn, side, [&](Long t) {
                        return m_.fall(turn_x_, side * t * m_.r_g) / (t * m_.r_g * m_.r_g);
                    });
    }
    const Mass& m_;
    PotentialStart start_;  // q, root_p, delta2 in these units
    Long x_;
    bool turns_, outside_;
    Long turn_x_ = 0, camera_t_ = 0;
};

class Jnw : public PotentialMetric<Mass> {
    using PotentialMetric::PotentialMetric;
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        if (!(ray.zeta0 * hole_.r_g < 1))
            return bad_input(fmt::format("zeta0 = {} lies on or within the singular surface", ray.zeta0));
        return PotentialMetric::from_reduced(ray);
    }
    std::unique_ptr<Orbit> swept(const PotentialStart& start) const override {
        return std::make_unique<Ray>(hole_, start);
    }
};

}  // namespace

OrbitMetricPtr make_janis_newman_winicour_orbits(const SpacetimeSpec& spec) {
    return std::make_unique<Jnw>(Mass(parameter_of(spec, "gamma", 0.8)));
}

}  // namespace nullscope::reference
