// Orbits in the wormhole of James, von Tunzelmann, Franklin and Thorne (2015), integrated over the proper length l as the metric
// gives it: dphi = b dl/(R sqrt(R^2 - b^2)), R = rho + M f(x), x = 2 (|l| - a)/(pi M), f = x atan x - ln(1 + x^2)/2.
//
// b > rho: the ray turns where R(x_t) = b; x = x_t cosh(w). b < rho: it passes; x = e sinh(w), e^2 = (rho^2 - b^2)/(rho M), at most 1
// (atan has its singularities at x = +-i). In w the rate is smooth, with its singularities at |Im w| = pi/2. All that nearly vanishes
// (R - b, rho - b, x - x_t) is formed on its own, in long double.
#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/plane_metrics.h"
#include "reference/smooth_segment.h"

namespace nullscope::reference {
namespace {

constexpr double kWidthOverMass = 1.42953;  // as the paper prints it
constexpr double kEnd = 1e10;  // R, of the largest length in the problem: what is left of a sweep is b/R to 1e-19

struct Throat {
    Long rho, half, mass, unit;  // unit: dl/dx
    Throat(double throat, double length, double width)
        : rho(throat), half(Long(0.5) * length * throat), mass(Long(width) * throat / Long(kWidthOverMass)) {
        unit = mass * 2 * std::atan(Long(1));
    }
    Long x_of(Long l) const { return std::max(std::abs(l) - half, Long(0)) / unit; }
    // f(x + t) - f(x) = integral of atan, x >= 0, t >= 0; the terms in front of t cancel at most to a third.
    template <class Number>
    static Number growth(Number x, Number t) {
        if (t == 0) return 0;
        if (x == 0 && t < Number(0.1)) {
            Number sum = 0, power = t * t;
            for (int n = 0; n < 14; ++n, power *= -t * t) sum += power / ((2 * n + 1) * (2 * n + 2));
            return sum;
        }
        const Number end = x + t, one = 1 + x * x;
        const Number relative = t / one * (x + end);
        return t * std::atan(end) + x * std::atan(t / (1 + x * end)) -
               (relative < Number(1e-3) ? Number(0.5) * std::log1p(relative) : Number(0.5) * std::log(1 + relative));
    }
    // t with f(x + t) - f(x) = more >= 0: f is convex, so Newton's steps come down from the right.
    static Long step_for(Long x, Long more) {
        if (!(more > 0)) return 0;
        const Long slope = std::atan(x);
        Long t = std::max(std::min(more / std::max(slope, Long(1e-300L)), std::sqrt(2 * more)), more * Long(0.6));
        for (int i = 0; i < 100; ++i) {
            const Long next = t - (growth(x, t) - more) / std::atan(x + t);
            const bool done = std::abs(next - t) <= 1e-10L * t;
            t = next > 0 ? next : t / 2;
            if (done && next > 0) break;
        }
        return t;
    }
};

// One side of the throat in the variable w >= 0: x = turn cosh(w), or x = turn sinh(w) of a passing ray.
struct Side {
    double rho, mass, unit, b, turn, base2, base, end;  // base2 and base: R^2 - b^2 and R at w = 0
    bool turns;
    Side(const Throat& m, const ThroatStart& start)
        : rho(static_cast<double>(m.rho)),
          mass(static_cast<double>(m.mass)),
          unit(static_cast<double>(m.unit)),
          b(static_cast<double>(start.b)),
          turns(start.turn2 > 0) {
        if (turns) {
            turn = static_cast<double>(Throat::step_for(0, start.turn2 / (start.b + m.rho) / m.mass));
            base2 = 0, base = b;
        } else {
            turn = static_cast<double>(std::min(std::sqrt(-start.turn2 / (m.rho * m.mass)), Long(1)));
            base2 = static_cast<double>(-start.turn2), base = rho;
        }
        const double far = kEnd * std::max({rho, b, mass, static_cast<double>(std::abs(start.l))});
        end = turns ? std::acosh(std::max(far / unit / turn, 1.0)) : std::asinh(far / unit / turn);
    }
    double offset(double w) const {  // x beyond w = 0
        const double half = std::sinh(0.5 * w);
        return turns ? 2 * turn * half * half : turn * std::sinh(w);
    }
    double x(double w) const { return turns ? turn * std::cosh(w) : turn * std::sinh(w); }
    struct At {
        double radius, root, dl;  // R, sqrt(R^2 - b^2), dl/dw over that root: regular where it vanishes
    };
    At at(double w) const {
        const double off = offset(w), grown = Throat::growth(turns ? turn : 0.0,
                                                             off);  // in double: a few roundings, a quarter of the time
        const double radius = base + mass * grown;
        const double root = std::sqrt(base2 + mass * grown * (radius + base));
        if (!turns) return {radius, root, unit * turn * std::cosh(w) / root};
        const double slope = off > 0 ? grown / off : std::atan(turn);
        return {radius, root, unit * std::cosh(0.5 * w) * std::sqrt(2 * turn / (mass * slope * (radius + base)))};
    }
    double w_of_offset(Long t) const {
        return turns ? 2 * std::asinh(std::sqrt(static_cast<double>(t) / (2 * turn)))
                     : std::asinh(static_cast<double>(t) / turn);
    }
    double rate(double w) const {  // dphi/dw
        const At a = at(w);
        return b * a.dl / a.radius;
    }
    template <class Part>
    double sum(double from, double to, const Part& part) const {
        return integrate_panels([&](double w) { return part(at(w)); }, from, to, kStep);
    }
    double swept(double from, double to) const {
        return sum(from, to, [this](const At& a) { return b * a.dl / a.radius; });
    }
    double beyond_end() const { return b / at(end).radius; }
    double beyond(double w) const { return w < end ? swept(w, end) + beyond_end() : b / at(w).radius; }
    // dt - dl and dt of a stretch; dt = R dl/sqrt(R^2 - b^2).
    double travel_time(double from, double to) const {
        return sum(from, to, [this](const At& a) { return b * (b / (a.radius + a.root) * a.dl); });
    }
    double travel_time_to_sky(double from) const {
        return (from < end ? travel_time(from, end) : 0.0) + 0.5 * b * (b / at(std::max(from, end)).radius);
    }
    double time(double from, double to) const {
        return sum(from, to, [](const At& a) { return a.radius * a.dl; });
    }
    static constexpr double kStep = 1.0;  // 20 nodes on a half-length of 1/2, singularities at pi/2: 6.4^-40
};

class Swept : public Orbit {
public:
    Swept(const Throat& m, const ThroatStart& start)
        : Orbit(static_cast<double>(start.l)), m_(m), start_(start), side_(m, start) {
        const Long x = m.x_of(start.l), grown = Throat::growth<Long>(0, x);
        on_ = start.l < 0 ? -1 : 1;
        in_tube_ = std::abs(start.l) <= m.half;
        if (side_.turns) {
            const Long more = start.away2 / (m.rho + m.mass * grown + start.b) / m.mass;  // (R - b)/M
            camera_ = side_.w_of_offset(Throat::step_for(side_.turn, more));
        } else {
            camera_ = side_.w_of_offset(x);
            tube_ = static_cast<double>(2 * m.half / m.rho) * side_.b / std::sqrt(side_.base2);
        }
        beyond_ = side_.beyond(camera_);
        to_middle_ = side_.swept(0, camera_);
        const double place =
            static_cast<double>(m.half > 0 ? std::clamp(start.l / m.half, Long(-1), Long(1)) : Long(on_));
        const double forward = start.outward ? 1 : -1;
        if (side_.turns) {
            leaves_ = forward == on_;
            fate_ = on_ > 0 ? Fate::kEscaped : Fate::kOtherSide;
            angle_ = leaves_ ? beyond_ : beyond_ + 2 * to_middle_;
            if (!leaves_) {
                turn_ = on_ * static_cast<double>(m.half + m.unit * side_.turn);
                turn_angle_ = to_middle_;
            }
            return;
        }
        leaves_ = !in_tube_ && forward == on_;
        fate_ = start.outward ? Fate::kEscaped : Fate::kOtherSide;
        tube_way_ = leaves_ ? 0 : static_cast<double>(m.half) * (1 - forward * place);
        const double tube_left = leaves_ ? 0 : 0.5 * tube_ * (1 - forward * place);
        last_ = leaves_ ? beyond_ : side_.beyond(0);
        angle_ = in_tube_ ? tube_left + last_ : leaves_ ? beyond_ : to_middle_ + tube_left + last_;
    }
    double place_at(double angle) const override {
        const double rest = angle_ - angle, half = static_cast<double>(m_.half), unit = side_.unit;
        const double last = side_.turns ? (leaves_ ? beyond_ : beyond_ + to_middle_) : last_;
        const double ends_on = side_.turns ? on_ : start_.outward ? 1 : -1;
        const auto place = [&](double w) { return half + unit * side_.x(w); };
        const auto rate = [this](double w) { return side_.rate(w); };
        if (rest <= last) {  // from the sky, whose digits count
            const double tail = side_.beyond_end();
            if (rest <= tail) return ends_on * (side_.b / rest + (place(side_.end) - side_.at(side_.end).radius));
            if (!from_sky_) from_sky_.emplace(side_.end, leaves_ ? camera_ : 0, Side::kStep);
            return ends_on * place((*from_sky_)(rate, tail - rest));
        }
        if (!in_tube_ && angle <= to_middle_) {
            if (!from_camera_) from_camera_.emplace(camera_, 0, Side::kStep);
            return on_ * place((*from_camera_)(rate, -angle));
        }
        return ends_on * half * (1 - 2 * (rest - last) / tube_);
    }
    // Of a ray that turns, elapsed time minus what |l| grows by; of one that passes, minus the length of its way.
    double delay() const override {
        if (leaves_) return side_.travel_time_to_sky(camera_);
        if (side_.turns) return side_.travel_time_to_sky(camera_) + 2 * side_.time(0, camera_);
        const double s = std::sqrt(side_.base2);  // in the tube dt/dl - 1 = rho/s - 1
        return side_.travel_time_to_sky(0) + side_.b * (side_.b / (s * (side_.rho + s))) * tube_way_ +
               (in_tube_ ? 0 : side_.travel_time(0, camera_));
    }

private:
    Throat m_;
    ThroatStart start_;
    Side side_;
    double on_ = 1, camera_ = 0, beyond_ = 0, to_middle_ = 0, tube_ = 0, tube_way_ = 0, last_ = 0;
    bool in_tube_ = false, leaves_ = false;
    mutable std::optional<PanelInverse> from_sky_, from_camera_;  // of w, once places there are asked for
};

class Dneg : public OrbitMetric {
public:
    explicit Dneg(const Throat& m) : m_(m) {}
    bool by_proper_length() const override { return true; }
    double lapse(double) const override { return 1; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        if (std::isinf(ray.q)) return orbit({ray.zeta0, 0, outward(ray), -1, 1});
        const Long b = 1 / Long(ray.q), more = m_.mass * Throat::growth<Long>(0, m_.x_of(ray.zeta0));
        const Long turn2 = (b - m_.rho) * (b + m_.rho), away2 = more * (more + 2 * m_.rho) - turn2;
        if (away2 < -kTurningSlack * b * b) return no_such_ray(ray, "l0");
        return orbit({ray.zeta0, b, outward(ray), turn2, std::max(away2, Long(0))});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long more = m_.mass * Throat::growth<Long>(0, m_.x_of(ray.r)), radius = m_.rho + more;
        const Long across = std::sqrt(more * (more + 2 * m_.rho)), along = radius * std::abs(Long(ray.n_r)),
                   b = radius * ray.n_t;
        // From afar b has the digits of what R^2 is many times as large as.
        const Long turn2 = b < along ? (b - m_.rho) * (b + m_.rho) : (across - along) * (across + along);
        return orbit({ray.r, b, ray.n_r > 0, turn2, along * along});
    }

private:
    std::unique_ptr<Orbit> orbit(const ThroatStart& at) const {
        return orbit_through_throat(at, m_.rho, 1,
                                    [this](const ThroatStart& start) { return std::make_unique<Swept>(m_, start); });
    }
    Throat m_;
};

}  // namespace

OrbitMetricPtr make_dneg_orbits(const SpacetimeSpec& spec) {
    const auto given = [&](const char* name, double fallback) { return parameter_of(spec, name, fallback); };
    return std::make_unique<Dneg>(Throat(given("throat", 1.0), given("length", 0.01), given("lensing_width", 0.05)));
}

}  // namespace nullscope::reference
