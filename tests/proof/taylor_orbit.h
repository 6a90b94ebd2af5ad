// Schwarzschild and Reissner-Nordstroem orbits in any precision, by Taylor series of the orbit equation: no elliptic function,
// no root of the quartic, no turning point to be treated apart. A = 1 - zeta + kappa zeta^2, kappa = (Q/M)^2/4.
//
//     zeta'' = -zeta + (3/2) zeta^2 - 2 kappa zeta^3,     zeta' = d zeta / d phi,     q^2 = zeta'^2 + zeta^2 A
//     v_camera - v = integral of d phi / (q - zeta'),   v = t + r_*
//
// The second from dt = -q dphi / (A zeta^2) backward in time, dr = -zeta' dphi / zeta^2 and A zeta^2 = (q - zeta')(q + zeta'),
// with A zeta^2 cancelled. Both recurrences are convolutions. A step goes to a fixed fraction of the radius of convergence.
#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace nullscope::proof {

template <class Real>
class TaylorOrbit {
public:
    // zeta0, slope = zeta' at the camera (> 0: inward), q. with_delay: only for rays that reach the sky.
    TaylorOrbit(Real zeta0, Real slope, Real q, bool with_delay, Real kappa = 0)
        : q_(q), kappa_(kappa), with_delay_(with_delay) {
        using std::sqrt;
        if (4 * kappa <= 1) horizon_ = 2 / (1 + sqrt(1 - 4 * kappa));
        Real phi = 0, zeta = zeta0, delay = 0;
        for (int step = 0; step < kMostSteps && !end_; ++step) {
            Segment s = series(phi, zeta, slope, delay);
            const Real h = s.length;
            const Real next = value(s.zeta, h), next_slope = derivative(s.zeta, h);
            if (slope > 0 && next_slope <= 0) turn_ = value(s.zeta, root_of_slope(s, slope / (slope - next_slope) * h));
            if (slope <= 0 && next_slope > 0) turn_ = value(s.zeta, root_of_slope(s, slope / (slope - next_slope) * h));
            if (next <= 0)
                finish(s, 0, false);
            else if (horizon_ && zeta < *horizon_ && next >= *horizon_)
                finish(s, *horizon_, true);
            else if (zeta > kDeep && slope > 0)
                return;
            segments_.push_back(s);
            phi += h;
            delay = value(s.delay, h);
            zeta = next;
            slope = next_slope;
        }
    }
    bool ended() const { return end_.has_value(); }  // false: falls to the singularity from inside the horizon
    bool captured() const { return captured_; }
    Real angle() const { return *end_; }
    Real delay() const { return end_delay_; }
    const std::optional<Real>& turn() const { return turn_; }
    Real zeta_at(Real phi) const { return at(phi, false); }
    Real slope_at(Real phi) const { return at(phi, true); }

private:
    static constexpr int kOrder = 40, kMostSteps = 4000;
    static constexpr int kDigits = std::numeric_limits<Real>::digits10;
    static constexpr double kDeep = 50;  // inside, and still falling
    struct Segment {
        Real start, length;
        std::vector<Real> zeta, delay;
    };

    Segment series(const Real& phi, const Real& zeta, const Real& slope, const Real& delay) const {
        Segment s{phi, 0, std::vector<Real>(kOrder + 1), {delay}};
        std::vector<Real>& z = s.zeta;
        z[0] = zeta;
        z[1] = slope;
        std::vector<Real> square(kOrder);
        for (int n = 0; n + 2 <= kOrder; ++n) {
            for (int i = 0; i < n - i; ++i) square[n] += z[i] * z[n - i];
            square[n] *= 2;
            if (n % 2 == 0) square[n] += z[n / 2] * z[n / 2];
            Real cube = 0;
            for (int i = 0; i <= n && kappa_ != 0; ++i) cube += z[i] * square[n - i];
            z[n + 2] = (Real(3) / 2 * square[n] - 2 * kappa_ * cube - z[n]) / ((n + 1) * (n + 2));
        }
        using std::abs;
        using std::min;
        s.length = reach(z, abs(zeta));
        if (with_delay_) {
            std::vector<Real> rate(kOrder);
            s.delay.resize(kOrder + 1);
            const Real first = q_ - slope;
            rate[0] = 1 / first;
            for (int n = 1; n < kOrder; ++n) {
                Real sum = 0;
                for (int k = 1; k <= n; ++k) sum += (k + 1) * z[k + 1] * rate[n - k];  // -(q - zeta')_k = (k+1) z_(k+1)
                rate[n] = sum / first;
            }
            for (int n = 0; n < kOrder; ++n) s.delay[n + 1] = rate[n] / (n + 1);
            s.length = min(s.length, reach(s.delay, abs(s.delay[1] * s.length)));
        }
        return s;
    }
    // How far the terms of the two last orders stay below 10^-(0.75 kDigits) of the scale.
    static Real reach(const std::vector<Real>& c, const Real& scale) {
        double length = 1e300;
        for (const int n : {kOrder - 1, kOrder}) {
            if (c[n] == 0) continue;
            using std::abs;
            using std::log;
            const double exponent = static_cast<double>(log(abs(c[n]))) - static_cast<double>(log(scale));
            length = std::fmin(length, std::exp((-0.75 * kDigits * std::log(10.0) - exponent) / n));
        }
        return Real(length);
    }
    static Real value(const std::vector<Real>& c, const Real& h) {
        Real sum = 0;
        for (std::size_t n = c.size(); n-- > 0;) sum = sum * h + c[n];
        return sum;
    }
    static Real derivative(const std::vector<Real>& c, const Real& h) {
        Real sum = 0;
        for (std::size_t n = c.size(); n-- > 1;) sum = sum * h + static_cast<int>(n) * c[n];
        return sum;
    }
    Real second_derivative(const std::vector<Real>& c, const Real& h) const {
        const Real z = value(c, h);
        return z * (z * (Real(3) / 2 - 2 * kappa_ * z) - 1);
    }
    static constexpr int kNewtonSteps = 12;
    Real root_of_slope(const Segment& s, Real h) const {
        for (int i = 0; i < kNewtonSteps; ++i) h -= derivative(s.zeta, h) / second_derivative(s.zeta, h);
        return h;
    }
    void finish(Segment& s, const Real& zeta, bool captured) {
        Real h = s.length;
        for (int i = 0; i < 4 * kNewtonSteps; ++i) h -= (value(s.zeta, h) - zeta) / derivative(s.zeta, h);
        end_ = s.start + h;
        end_delay_ = value(s.delay, h);
        captured_ = captured;
    }
    Real at(const Real& phi, bool slope) const {
        std::size_t i = 0;
        while (i + 1 < segments_.size() && phi > segments_[i + 1].start) ++i;
        const Real h = phi - segments_[i].start;
        return slope ? derivative(segments_[i].zeta, h) : value(segments_[i].zeta, h);
    }

    Real q_, kappa_;
    std::optional<Real> horizon_;
    bool with_delay_, captured_ = false;
    std::vector<Segment> segments_;
    std::optional<Real> end_, turn_;
    Real end_delay_ = 0;
};

}  // namespace nullscope::proof
