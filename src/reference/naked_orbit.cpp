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

#include "reference/potential_orbit.h"

namespace nullscope::reference {
namespace {

struct Charge {
    Long horizon = std::numeric_limits<Long>::infinity();
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
    bool has_circle() const { return traps; }
    Long lapse2(Long r) const { return 1 - 1 / r + kappa / (r * r); }
    Long radius(Long r) const { return r; }
    Long fall_speed(Long r) const { return std::sqrt(r - kappa) / r; }  // nothing falls from infinity below r = kappa
    Long v(Long z) const { return z * z * (1 - z + kappa * z * z); }
    Long p(Long q, Long z) const { return (q - z) * (q + z) + z * z * z * (1 - kappa * z); }
    Long below(Long x) const { return -x * (tilt + x * (bow + x * (third + x * kappa))); }
};

struct BounceLeg : LegEnds {
    BounceLeg(const Charge& m, const PotentialStart& start) : LegEnds{true, 0}, m_(m), start_(start) {
        find_roots();
        turn = static_cast<double>(e_);
        nearest = std::min(e_, m.sphere);
        camera = w_of(std::sqrt(camera_distance(start, {e_, off_}, -1, [this](Long t) { return bracket(t); })));
        first = w_of(0);
        end = w_of(std::sqrt(e_));
    }
    double zeta(double w) const { return static_cast<double>(place(w)); }
    double rate(double w) const {
        const Long s = s_of(w);
        return static_cast<double>(2 * mu_ * std::cosh(w) / std::sqrt(bracket(s * s)));
    }
    double root_p(double w) const {
        const Long s = s_of(w);
        return static_cast<double>(std::abs(s) * std::sqrt(bracket(s * s)));
    }
    double near_sky(double w) const {  // e - s^2 = (S - s)(S + s)
        const double apart = 2 * mu_ * std::cosh(0.5 * (end + w)) * std::sinh(0.5 * (end - w));
        return apart * (std::sqrt(turn) + s_of(w));
    }
    double sky_rate(double z) const { return static_cast<double>(1 / std::sqrt(m_.p(start_.q, z))); }
    // q dphi/(zeta^2 A) from the camera to the turning point; in log(zeta) far from it.
    double inward_delay() const {
        const auto weight = [this](Long z) {
            return static_cast<double>(start_.q / (z * z * (1 - z + m_.kappa * z * z)));
        };
        const auto near = [&](double w) { return rate(w) * weight(place(w)); };
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
        if (start_.zeta0 >= split) return crowded(first, camera);
        const auto far = [&](double y) {
            const double z = std::exp(y);
            return z * weight(z) * sky_rate(z);
        };
        return crowded(first, w_of(std::sqrt(e_ - split))) +
               integrate_panels(far, static_cast<double>(std::log(start_.zeta0)), static_cast<double>(std::log(split)));
    }

private:
    double s_of(double w) const { return static_cast<double>(sigma_) + mu_ * std::sinh(w); }
    double w_of(Long s) const { return std::asinh(static_cast<double>((s - sigma_) / mu_)); }
    Long place(double w) const {
        const Long s = s_of(w);
        return e_ - s * s;
    }
    // P as seen from the turning point, and from the photon sphere next to it.
    Long bracket(Long t) const {
        const Long x = e_ - t - m_.sphere;
        if (t > 0 && std::abs(x) < Long(0.3) * std::abs(e_ - m_.sphere)) return (start_.delta2 + m_.below(x)) / t;
        return c_[0] + t * (c_[1] + t * (c_[2] + t * c_[3]));
    }
    void find_roots() {
        const Long q = start_.q, sphere = m_.sphere, d = start_.delta2;
        const auto near_sphere = [&](Long x) { return d + m_.below(x); };
        const auto far = [&](Long z) { return m_.p(q, z); };
        if (d < 0 && q < m_.q_crit / 2) {  // far outside of the sphere zeta itself keeps the digits
            e_ = root_between(far, 0, sphere);
            off_ = e_ - sphere;
        } else {
            Long high = 1;
            while (d >= 0 && near_sphere(high) > 0) high *= 2;
            off_ = d < 0 ? -root_between([&](Long y) { return -near_sphere(-y); }, 0, sphere)
                         : root_between(near_sphere, 0, high);
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
            mu_ =
                static_cast<double>(std::sqrt(std::max(std::min(c_[0] / std::max(c_[1], Long(1e-30L)), e_), Long(0))));
        if (std::abs(s) > 2 * std::sqrt(e_)) sigma_ = 0, mu_ = static_cast<double>(std::sqrt(e_));  // far from the path
        mu_ = std::clamp(mu_, 1e-15, static_cast<double>(std::sqrt(e_)));
    }
    const Charge& m_;
    PotentialStart start_;
    Long e_ = 0, off_ = 0, sigma_ = 0;
    std::array<Long, 4> c_{};
    double mu_ = 1;
};

class Naked : public PotentialMetric<Charge> {
    using PotentialMetric::PotentialMetric;
    std::unique_ptr<Orbit> swept(const PotentialStart& start) const override {
        if (hole_.traps && start.delta2 < 0 && start.zeta0 > hole_.sphere)  // trapped
            return std::make_unique<StandingOrbit>(static_cast<double>(start.zeta0), Fate::kNoSky);
        return std::make_unique<LeggedOrbit<BounceLeg>>(hole_, start);
    }
};

}  // namespace

OrbitMetricPtr make_naked_orbits(double charge) { return std::make_unique<Naked>(Charge(charge)); }

}  // namespace nullscope::reference
