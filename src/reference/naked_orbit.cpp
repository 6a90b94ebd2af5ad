// Orbits about a Reissner-Nordstrom charge without horizon, Q/M > 1: (dzeta/dphi)^2 = P = q^2 - zeta^2 (1 - zeta + kappa zeta^2).
//
// V grows without bound inward, so every ray from the sky turns, at the least root e of P that it meets, and comes back. From there
// zeta = e - s^2, P = s^2 (c1 + c2 s^2 + c3 s^4 + c4 s^6), and with the root s = sigma + i mu of the bracket that is nearest to the path
// s = sigma + mu sinh(w): in w the rate is smooth, however close to the photon sphere a ray comes. Between the two photon spheres of
// 1 < Q/M <= sqrt(9/8) rays can be trapped: they have no sky.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "reference/plane_metrics.h"
#include "reference/smooth_leg.h"

namespace nullscope::reference {
namespace {

constexpr double kRadialQ = 1e30, kLeastQ = 1e-60;  // beyond: radial; below: the regular limit

struct Charge {
    Long kappa, sphere, q_crit;  // sphere: zeta of the outer photon sphere, or where dV/dzeta is least
    Long tilt, bow, third;       // q_crit^2 - V = -x (tilt + x (bow + x (third + x kappa))), x = zeta - sphere
    bool traps;                  // there is a photon sphere
    explicit Charge(double charge) {
        const Long q = charge, s2 = (1 - q) * (1 + q), inside = 1 + 8 * s2;  // 9 - 32 kappa
        kappa = q * q / 4;
        traps = inside >= 0;
        sphere = traps ? 4 / (3 + std::sqrt(inside)) : 3 / (8 * kappa);
        q_crit = std::sqrt(v(sphere));
        tilt = traps ? 0 : sphere * (2 - sphere * (3 - 4 * kappa * sphere));
        bow = 1 - sphere * (3 - 6 * kappa * sphere);
        third = 4 * kappa * sphere - 1;
    }
    Long lapse2(Long r) const { return 1 - 1 / r + kappa / (r * r); }
    Long v(Long z) const { return z * z * (1 - z + kappa * z * z); }
    Long below(Long x) const { return -x * (tilt + x * (bow + x * (third + x * kappa))); }
};

// At the camera. root_p = sqrt(P), delta2 = q^2 - q_crit^2 do not follow from q and zeta0 in double. s = +1: inward.
struct Start {
    Long q, zeta0;
    int s;
    Long root_p, delta2;
};

class Bounce : public Orbit {
public:
    Bounce(const Charge& m, const Start& start) : m_(m), start_(start) {
        if (m.traps && start.delta2 < 0 && start.zeta0 > m.sphere) return;  // trapped
        find_roots();
        near_sky_ = start.s < 0 && start.zeta0 < std::min(e_, m.sphere) / 4;
        if (near_sky_) {
            fate_ = Fate::kEscaped;
            angle_ = integrate_panels([this](double z) { return sky_rate(z); }, 0, static_cast<double>(start.zeta0));
            return;
        }
        camera_ = w_of(camera_s());
        zero_ = w_of(0);
        sky_ = w_of(std::sqrt(e_));
        fate_ = Fate::kEscaped;
        out_ = sweep(camera_, sky_);
        if (start.s < 0) {
            angle_ = out_;
            return;
        }
        turn_ = static_cast<double>(e_);
        turn_angle_ = sweep(zero_, camera_);
        angle_ = 2 * turn_angle_ + out_;
    }
    double zeta_at(double angle) const override {
        if (angle == 0) return static_cast<double>(start_.zeta0);
        if (fate_ == Fate::kNoSky || has_ended(angle)) return kNotANumber;
        if (near_sky_)
            return invert_panels([this](double z) { return sky_rate(z); }, 0, static_cast<double>(start_.zeta0),
                                 angle_ - angle);
        const auto rate = [this](double w) { return this->rate(w); };
        const double rest = angle_ - angle, whole = out_ + (turn_ == turn_ ? turn_angle_ : 0);
        if (turn_ == turn_ && angle < turn_angle_) return place(invert_panels(rate, camera_, zero_, -angle));
        // From the sky, where zeta is small and its digits count: e - s^2 = (S - s)(S + s).
        const double from = turn_ == turn_ ? zero_ : camera_;
        if (rest < 0.5 * whole) {
            const double w = invert_panels(rate, sky_, from, -rest);
            const double apart = 2 * mu_ * std::cosh(0.5 * (sky_ + w)) * std::sinh(0.5 * (sky_ - w));
            return apart * (std::sqrt(static_cast<double>(e_)) + s_of(w));
        }
        return place(invert_panels(rate, from, sky_, angle - (turn_ == turn_ ? turn_angle_ : 0)));
    }
    double delay() const override {
        if (fate_ != Fate::kEscaped) return kNotANumber;
        const double q = static_cast<double>(start_.q);
        if (near_sky_)
            return integrate_panels([&](double z) { return sky_rate(z) / (q + 1 / sky_rate(z)); }, 0,
                                    static_cast<double>(start_.zeta0));
        const double out = integrate_panels([&](double w) { return rate(w) / (q + root_p(w)); }, camera_, sky_);
        if (start_.s < 0) return out;
        return out + 2 * inward_delay();
    }

private:
    // q dphi/(zeta^2 A) from the camera to the turning point; in log(zeta) far from it.
    double inward_delay() const {
        const auto weight = [this](Long z) {
            return static_cast<double>(start_.q / (z * z * (1 - z + m_.kappa * z * z)));
        };
        const auto near = [&](double w) { return rate(w) * weight(zeta(w)); };
        // A has its zeros close to the path where the charge is nearly 1, or e large: panels that grow with the distance from there.
        const std::complex<Long> zero(1 / (2 * m_.kappa),
                                      std::sqrt(std::max(4 * m_.kappa - 1, Long(0))) / (2 * m_.kappa));
        const std::complex<Long> there = std::asinh((std::sqrt(e_ - zero) - sigma_) / Long(mu_));
        const double middle = static_cast<double>(there.real()),
                     finest = std::max(std::abs(static_cast<double>(there.imag())), 1e-12);
        const auto crowded = [&](double from, double to) {
            double sum = 0;
            for (double at = from; at < to;) {
                const double next = std::min({to, at + kPanel,
                                              at < middle ? std::max(at + finest, at + 0.5 * (middle - at))
                                                          : at + std::max(finest, at - middle)});
                sum += PanelGauss::integrate(near, at, next);
                at = next;
            }
            return sum;
        };
        const Long split = std::min(e_, m_.sphere) / 2;
        if (start_.zeta0 >= split) return crowded(zero_, camera_);
        const auto far = [&](double y) {
            const double z = std::exp(y);
            return z * weight(z) * sky_rate(z);
        };
        return crowded(zero_, w_of(std::sqrt(e_ - split))) +
               integrate_panels(far, static_cast<double>(std::log(start_.zeta0)), static_cast<double>(std::log(split)));
    }
    // P as seen from the turning point, and from the photon sphere next to it.
    Long bracket(Long t) const {
        const Long x = e_ - t - m_.sphere;
        if (t > 0 && std::abs(x) < Long(0.3) * std::abs(e_ - m_.sphere)) return (start_.delta2 + m_.below(x)) / t;
        return c_[0] + t * (c_[1] + t * (c_[2] + t * c_[3]));
    }
    double s_of(double w) const { return static_cast<double>(sigma_) + mu_ * std::sinh(w); }
    double w_of(Long s) const { return std::asinh(static_cast<double>((s - sigma_) / mu_)); }
    Long zeta(double w) const {
        const Long s = s_of(w);
        return e_ - s * s;
    }
    // An outward ray from far away keeps its digits in zeta itself.
    double sky_rate(double z) const {
        const Long zeta = z, q = start_.q;
        return static_cast<double>(1 / std::sqrt((q - zeta) * (q + zeta) + zeta * zeta * zeta * (1 - m_.kappa * zeta)));
    }
    double place(double w) const { return static_cast<double>(zeta(w)); }
    double rate(double w) const {
        const Long s = s_of(w);
        return static_cast<double>(2 * mu_ * std::cosh(w) / std::sqrt(bracket(s * s)));
    }
    double root_p(double w) const {
        const Long s = s_of(w);
        return static_cast<double>(std::abs(s) * std::sqrt(bracket(s * s)));
    }
    double sweep(double from, double to) const {
        return integrate_panels([this](double w) { return rate(w); }, from, to);
    }
    // P(t) = root_p^2: t = root_p^2/bracket(t) keeps the digits that zeta0 - e has lost.
    Long camera_s() const {
        Long t = std::max(e_ - start_.zeta0, Long(0));
        for (int i = 0; i < 40 && t < Long(0.05) * e_; ++i) t = start_.root_p * start_.root_p / bracket(t);
        return std::sqrt(t);
    }
    // A root of f between low, where it is positive, and high, where it is not.
    template <class F>
    static Long root_between(const F& f, Long low, Long high) {
        for (int i = 0; i < 200 && std::abs(high - low) > 1e-19L * std::abs(high); ++i) {
            const Long middle = (low + high) / 2;
            (f(middle) > 0 ? low : high) = middle;
        }
        return (low + high) / 2;
    }
    void find_roots() {
        const Long q = start_.q, sphere = m_.sphere, d = start_.delta2;
        const auto near_sphere = [&](Long x) { return d + m_.below(x); };
        const auto far = [&](Long z) { return (q - z) * (q + z) + z * z * z * (1 - m_.kappa * z); };
        if (d < 0) {  // outside of the sphere; far from it zeta itself keeps the digits
            e_ = q < m_.q_crit / 2 ? root_between(far, 0, sphere) : sphere + root_between(near_sphere, -sphere, 0);
            off_ = e_ - sphere;
            if (!(q < m_.q_crit / 2)) off_ = -root_between([&](Long y) { return -near_sphere(-y); }, 0, sphere);
        } else {
            Long high = 1;
            while (near_sphere(high) > 0) high *= 2;
            off_ = root_between(near_sphere, 0, high);
            e_ = sphere + off_;
        }
        c_ = {2 * e_ - 3 * e_ * e_ + 4 * m_.kappa * e_ * e_ * e_, -(1 - 3 * e_ + 6 * m_.kappa * e_ * e_),
              4 * m_.kappa * e_ - 1, -m_.kappa};
        if (std::abs(off_) < Long(0.3) * sphere)  // V'(e) by its expansion about the sphere, where it vanishes
            c_[0] = m_.tilt + off_ * (2 * m_.bow + off_ * (3 * m_.third + off_ * 4 * m_.kappa));
        Long low = 1;
        while (far(-low) > 0) low *= 2;
        const Long b = -root_between([&](Long z) { return far(-z); }, 0, low);
        const Long half = (e_ + b - 1 / m_.kappa) / 2, rest = -q * q / (m_.kappa * e_ * b), disc = half * half - rest;
        // The two other roots: nearest to the path in s = sqrt(e - zeta).
        const std::complex<Long> root =
            disc >= 0 ? std::complex<Long>(-half - std::sqrt(disc)) : std::complex<Long>(-half, std::sqrt(-disc));
        const std::complex<Long> s = std::sqrt(std::complex<Long>(e_) - root);
        sigma_ = disc >= 0 ? 0 : s.real();
        mu_ = static_cast<double>(std::abs(s.imag()));
        if (disc >= 0)
            mu_ = static_cast<double>(
                std::sqrt(std::max(std::min(c_[0] / std::max(-bow_of(), Long(1e-30L)), e_), Long(0))));
        if (std::abs(s) > 2 * std::sqrt(e_)) sigma_ = 0, mu_ = static_cast<double>(std::sqrt(e_));  // far from the path
        mu_ = std::clamp(mu_, 1e-15, static_cast<double>(std::sqrt(e_)));
    }
    Long bow_of() const { return -c_[1]; }
    Charge m_;
    Start start_;
    Long e_ = 0, off_ = 0, sigma_ = 0;
    std::array<Long, 4> c_{};
    bool near_sky_ = false;
    double mu_ = 1, camera_ = 0, zero_ = 0, sky_ = 0, out_ = 0;
};

class Naked : public OrbitMetric {
public:
    explicit Naked(double charge) : m_(charge) {}
    double lapse(double r) const override { return std::sqrt(static_cast<double>(m_.lapse2(r))); }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const Long q = std::max(ray.q, kLeastQ), zeta0 = ray.zeta0;
        Long p = 0, delta2 = 0;
        if (ray.q < kRadialQ) {
            p = (q - zeta0) * (q + zeta0) + zeta0 * zeta0 * zeta0 * (1 - m_.kappa * zeta0);
            delta2 = (q - m_.q_crit) * (q + m_.q_crit);
            if (p < -kTurningSlack * q * q) return no_such_ray(ray, "zeta0", ": q^2 < V(zeta0)");
        }
        return orbit({q, zeta0, ray.s, std::sqrt(std::max(p, Long(0))), delta2});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long q = std::sqrt(m_.lapse2(ray.r)) / ray.r / ray.n_t;
        return local(ray.r, q, q * std::abs(ray.n_r), ray.n_r <= 0 ? 1 : -1);
    }
    // w = sqrt(1 - A) = sqrt((r - kappa)/r^2): nothing falls from infinity below r = kappa.
    RainOrbit from_rain(const LocalRay& ray) const override {
        const Long r = ray.r;
        if (!(r >= m_.kappa)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        const Long w = std::sqrt(r - m_.kappa) / r;
        const auto [energy, outward] = RainStart<Long>(ray, w, -m_.lapse2(r) / (1 + w));
        if (!(energy > 0)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        return {local(r, energy / (r * ray.n_t), std::abs(outward) / (r * ray.n_t), outward > 0 ? -1 : 1),
                static_cast<double>(1 / energy)};
    }

private:
    std::unique_ptr<Orbit> local(Long r, Long q, Long root_p, int s) const {
        const Long x = (1 - r * m_.sphere) / r, below = m_.below(x);
        Start start{q, 1 / r, s, root_p, (q - m_.q_crit) * (q + m_.q_crit)};
        if (root_p * root_p + std::abs(below) < m_.q_crit * m_.q_crit / 4) start.delta2 = root_p * root_p - below;
        return orbit(start);
    }
    std::unique_ptr<Orbit> orbit(Start start) const {
        const double zeta0 = static_cast<double>(start.zeta0);
        if (!(start.q < kRadialQ))
            return std::make_unique<StandingOrbit>(zeta0, Fate::kEscaped, true);  // in, and back the same way
        if (m_.traps && start.delta2 == 0) {
            if (start.root_p == 0) return std::make_unique<StandingOrbit>(zeta0, Fate::kNoSky, false);
            start.delta2 = std::pow(Long(std::numeric_limits<double>::epsilon()), 2);
        }
        return std::make_unique<Bounce>(m_, start);
    }
    Charge m_;
};

}  // namespace

OrbitMetricPtr make_naked_orbits(double charge) { return std::make_unique<Naked>(charge); }

}  // namespace nullscope::reference
