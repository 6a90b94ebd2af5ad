// Light about a rotating black hole in any precision, by Taylor series in Mino time of Carter's separated equations:
//
//     zeta'' = A zeta + (3/2) K zeta^2 + 2 B zeta^3,   zeta = r_s/r,  A = 2(a^2 - a l) - K,  B = (a^2 - a l)^2 - a^2 K
//     mu''   = A mu - 2 a^2 mu^3,                      mu = cos(theta)
//     phi'   = -l/(1 - mu^2) - a zeta (1 - a l zeta)/(1 - zeta + a^2 zeta^2)
//     w'     = K (1 + a^2 zeta^2)/(1 + (a^2 - a l) zeta^2 + |zeta'|) + a (l - a (1 - mu^2))
//
// of a ray traced backward in time, energy 1, l = L_z and K = Carter's constant of the photon; w is the time that it
// has been on its way plus r_* on the way in, less r_* on the way out, which has no pole. Derived from Bardeen, Press
// and Teukolsky 1972, eq. 2.9, in units of r_s. Far away every one of these numbers is as good as Real: there is no
// difference of great ones.
#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace nullscope::proof {

template <class Real>
class TaylorKerr {
public:
    // of a camera without angular momentum, outside the horizon; look: along e_r, e_theta, e_phi, of any length
    struct Start {
        Real a, r, theta, look_r, look_theta, look_phi;
    };
    struct Crossing {
        Real r, phi, delay;  // phi: from the camera's; delay: the camera's t less t there
    };

    explicit TaylorKerr(const Start& start, bool follow = true) : a_(start.a) {
        using std::cos, std::sin, std::sqrt;
        const Real r = start.r, sine = sin(start.theta), a2 = a_ * a_;
        place_.mu = cos(start.theta), place_.zeta = 1 / r;
        const Real sigma = r * r + a2 * place_.mu * place_.mu, across = r * r + a2, delta = r * r - r + a2;
        const Real area = across * sigma + a2 * r * sine * sine, girth = sqrt(area / sigma);
        const Real norm =
            sqrt(start.look_r * start.look_r + start.look_theta * start.look_theta + start.look_phi * start.look_phi);
        const Real l = -girth * start.look_phi * sine, energy = sqrt(delta * sigma / area) * norm + a_ * r / area * l;
        l_ = l / energy, energy_ = energy;
        const Real p = sqrt(sigma) * start.look_theta / energy, w = -girth * start.look_phi / energy - a_ * sine;
        carter_ = p * p + w * w;
        place_.zeta_slope = -sqrt(sigma * delta) * start.look_r / energy / (r * r);
        place_.mu_slope = -sine * p;
        square_ = 2 * (a2 - a_ * l_) - carter_, fourth_ = (a2 - a_ * l_) * (a2 - a_ * l_) - a2 * carter_;
        root_ = sqrt(1 - 4 * a2), horizon_ = (1 + root_) / 2;
        first_ = tortoise(place_.zeta);
        if (follow) run();
    }
    // Of a ray that is traced inward from outside the photon orbits: does (dr/dtau)^2 fall below 0 before the horizon?
    // No series is needed.
    bool turns() const {
        using std::sqrt;
        // The first minimum of 1 + square zeta^2 + K zeta^3 + fourth zeta^4.
        const Real d = 9 * carter_ * carter_ - 32 * square_ * fourth_;
        if (d < 0) return square_ < 0;  // it falls for ever
        const Real z = -4 * square_ / (3 * carter_ + sqrt(d));
        return z * horizon_ < 1 && 1 + z * z * (square_ + z * (carter_ + z * fourth_)) < 0;
    }
    bool ended() const { return ended_; }
    bool captured() const { return captured_; }
    Real mu() const { return place_.mu; }    // of the sky; escaped rays
    Real phi() const { return place_.phi; }  // from the camera's, windings kept
    Real delay() const { return delay_; }    // v at the camera less v at the sky
    Real l() const { return l_; }
    Real energy() const { return energy_; }  // at infinity, over that at the camera
    const std::vector<Crossing>& crossings() const { return crossings_; }

private:
    static constexpr int kOrder = std::numeric_limits<Real>::digits10 > 30 ? 45 : 30, kMostSegments = 20000;
    // nothing turns nearer to it below spin 0.9999, and phi has a pole there: captured
    static constexpr double kNearHorizon = 1e-4;
    using Series = std::vector<Real>;
    struct Place {
        Real zeta, zeta_slope, mu, mu_slope, phi = 0, w = 0;
    };
    struct Segment {
        Series zeta, mu, phi, w;
    };

    static Series product(const Series& x, const Series& y, int terms) {
        Series z(kOrder + 1, Real(0));
        for (int n = 0; n < terms; ++n)
            for (int i = 0; i <= n; ++i) z[n] += x[i] * y[n - i];
        return z;
    }
    static Series quotient(const Series& x, const Series& y) {
        Series z(kOrder + 1, Real(0));
        for (int n = 0; n < kOrder; ++n) {
            Real sum = x[n];
            for (int i = 1; i <= n; ++i) sum -= y[i] * z[n - i];
            z[n] = sum / y[0];
        }
        return z;
    }
    static Series integral(const Series& x, const Real& start) {
        Series z(kOrder + 1, start);
        for (int n = 0; n < kOrder; ++n) z[n + 1] = x[n] / (n + 1);
        return z;
    }
    // y'' = one y + two y^2 + three y^3
    static Series oscillator(const Real& y, const Real& slope, const Real& one, const Real& two, const Real& three) {
        Series c(kOrder + 1, Real(0)), square(kOrder + 1, Real(0));
        c[0] = y, c[1] = slope;
        for (int n = 0; n + 2 <= kOrder; ++n) {
            Real cube = 0;
            for (int i = 0; i <= n; ++i) square[n] += c[i] * c[n - i];
            for (int i = 0; i <= n; ++i) cube += square[i] * c[n - i];
            c[n + 2] = (one * c[n] + two * square[n] + three * cube) / ((n + 1) * (n + 2));
        }
        return c;
    }
    static Real value(const Series& c, const Real& h) {
        Real sum = 0;
        for (std::size_t n = c.size(); n-- > 0;) sum = sum * h + c[n];
        return sum;
    }
    static Real slope(const Series& c, const Real& h) {
        Real sum = 0;
        for (std::size_t n = c.size(); n-- > 1;) sum = sum * h + static_cast<int>(n) * c[n];
        return sum;
    }
    // How far the terms of the two last orders stay below a unit in the last place of 1.
    static double reach(const Series& c) {
        using std::abs, std::log;
        double length = 1e300;
        for (const int n : {kOrder - 1, kOrder})
            if (c[n] != 0)
                length = std::fmin(length, std::exp((-std::numeric_limits<Real>::digits * std::log(2.0) -
                                                     static_cast<double>(log(abs(c[n])))) /
                                                    n));
        return length;
    }
    // A zero of c between 0 and h, where it changes sign: Newton's steps, halved where they leave the bracket.
    static Real zero(const Series& c, const Real& h, bool of_slope) {
        Real low = 0, high = h, at = h / 2;
        const auto f = [&](const Real& x) { return of_slope ? slope(c, x) : value(c, x); };
        const bool rising = f(high) > 0;
        for (int i = 0; i < 200; ++i) {
            const Real y = f(at);
            ((y > 0) == rising ? high : low) = at;
            Real d = 0;
            if (of_slope)
                for (std::size_t n = c.size(); n-- > 2;) d = d * at + static_cast<int>(n * (n - 1)) * c[n];
            else
                d = slope(c, at);
            Real next = at - y / d;
            if (!(next > low && next < high)) next = (low + high) / 2;
            using std::abs;
            const bool done = abs(next - at) <= abs(at) * std::numeric_limits<Real>::epsilon();
            at = next;
            if (done) break;
        }
        return at;
    }

    Segment segment(int sense) const {
        const Real a2 = a_ * a_, m = a2 - a_ * l_;
        Segment s;
        s.zeta = oscillator(place_.zeta, place_.zeta_slope, square_, Real(3) / 2 * carter_, 2 * fourth_);
        s.mu = oscillator(place_.mu, place_.mu_slope, square_, Real(0), -2 * a2);
        const Series z2 = product(s.zeta, s.zeta, kOrder), mu2 = product(s.mu, s.mu, kOrder);
        Series by_theta(kOrder + 1, Real(0)), above(by_theta), below(by_theta), sine2(by_theta), pull(by_theta),
            fall(by_theta);
        for (int n = 0; n < kOrder; ++n) {
            const Real one = n == 0 ? 1 : 0;
            by_theta[n] = -l_ * one;
            sine2[n] = one - mu2[n];
            above[n] = -a_ * (s.zeta[n] - a_ * l_ * z2[n]);
            below[n] = one - s.zeta[n] + a2 * z2[n];
            pull[n] = carter_ * (one + a2 * z2[n]);
            fall[n] = one + m * z2[n] + sense * (n + 1) * s.zeta[n + 1];
        }
        Series rate = quotient(by_theta, sine2);
        const Series drag = quotient(above, below), late = quotient(pull, fall);
        Series time(kOrder + 1, Real(0));
        for (int n = 0; n < kOrder; ++n)
            rate[n] += drag[n], time[n] = late[n] + a_ * ((n == 0 ? l_ : Real(0)) - a_ * sine2[n]);
        s.phi = integral(rate, place_.phi), s.w = integral(time, place_.w);
        return s;
    }

    // r_* without its constant, from zeta.
    Real tortoise(const Real& zeta) const {
        using std::log;
        const Real inner = (1 - root_) / 2;
        return 1 / zeta - log(zeta) + (horizon_ * log(1 - horizon_ * zeta) - inner * log(1 - inner * zeta)) / root_;
    }

    void run() {
        int sense = place_.zeta_slope > 0 ? 1 : -1;
        Real offset = sense > 0 ? first_ : -first_;  // late = w + offset -/+ r_*
        if (sense < 0) delay_ = 0;
        for (int i = 0; i < kMostSegments && !ended_; ++i) {
            const Segment s = segment(sense);
            Real h = std::fmin(std::fmin(reach(s.zeta), reach(s.mu)), std::fmin(reach(s.phi), reach(s.w)));
            bool turned = false;
            if (sense > 0 && slope(s.zeta, h) < 0) h = zero(s.zeta, h, true), turned = true;
            if (sense > 0 && value(s.zeta, h) * horizon_ >= 1 - kNearHorizon) ended_ = captured_ = true;
            if (sense < 0 && value(s.zeta, h) <= 0) h = zero(s.zeta, h, false), ended_ = true;
            if (!captured_ && place_.mu != 0 && (value(s.mu, h) > 0) != (place_.mu > 0)) {
                const Real at = zero(s.mu, h, false), zeta = value(s.zeta, at);
                crossings_.push_back({1 / zeta, value(s.phi, at), value(s.w, at) + offset - sense * tortoise(zeta)});
            }
            place_ = {value(s.zeta, h), slope(s.zeta, h), value(s.mu, h),
                      slope(s.mu, h),   value(s.phi, h),  value(s.w, h)};
            if (turned) sense = -1, offset -= 2 * tortoise(place_.zeta);
        }
        if (ended_ && !captured_) delay_ = place_.w + offset + first_;
    }

    Real a_, l_, energy_, carter_, square_, fourth_, root_, horizon_, first_, delay_ = 0;
    Place place_{};
    bool ended_ = false, captured_ = false;
    std::vector<Crossing> crossings_;
};

}  // namespace nullscope::proof
