// Schwarzschild orbits in closed form: (dzeta/dphi)^2 = P(zeta) = q^2 - zeta^2 + zeta^3.
//
// With D = zeta - 2/3: P = delta2 + D^2 (zeta + 1/3), delta2 = q^2 - q_crit^2, which is formed
// without rounding of q_crit = 2/(3 sqrt 3). The roots of P follow from Viete: with zeta = 1/3 + (2/3) cos(t),
// P = q^2 - q_crit^2 sin^2(3t/2). All differences of roots are products of sines (hyperbolic for q > q_crit).
//
// Four kinds of orbit: flyby (q < q_crit outside the photon sphere), inner (q < q_crit inside it), passing (q > q_crit,
// monotone from infinity to the singularity or back) and radial (q infinite).
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/exact_product.h"
#include "reference/elliptic.h"
#include "reference/plane_metrics.h"
#include "reference/smooth_segment.h"

namespace nullscope::reference {
namespace {

// q_crit = 2/(3 sqrt 3) and 2/3 as sums of two doubles.
constexpr double kCritical = 0.3849001794597505, kCriticalRest = -1.4707246994600989e-17;
constexpr double kTwoThirds = 2.0 / 3.0, kTwoThirdsRest = 3.7007434154171886e-17;
// Beyond this q a ray is radial: its swept angle, about zeta0 / q, is below everything (and q^2 must not overflow).
constexpr double kRadialQ = 1e60;
constexpr double kLeastQ = 1e-60;  // the limit q -> 0 is regular: this stands for smaller q

// A ray at its camera. root_p = sqrt(P(zeta0)) >= 0, beyond = zeta0 - 2/3 and lapse2 = 1 - zeta0 are given apart
// because they cannot be recomputed from zeta0 and q near the turning point, the photon sphere and the horizon.
struct SchwarzschildStart {
    double q, zeta0;
    int s;  // +1: towards the hole
    double root_p, delta2, beyond, lapse2;
};

double square(double x) { return x * x; }

// Swept angle between two points of an orbit whose factors zeta - e_i keep their signs (Carlson; DLMF 19.29.4): factors
// are |zeta - e_i| at one end, others at the other end, width > 0 the difference of zeta.
struct Factors {
    double a, b, c;
};
double angle_between_points(const Factors& x, const Factors& y, double width) {
    if (width == 0) return 0;
    const double xa = std::sqrt(x.a), xb = std::sqrt(x.b), xc = std::sqrt(x.c);
    const double ya = std::sqrt(y.a), yb = std::sqrt(y.b), yc = std::sqrt(y.c);
    const double ab = (xa * xb * yc + ya * yb * xc) / width, ac = (xa * xc * yb + ya * yc * xb) / width;
    const double bc = (xb * xc * ya + yb * yc * xa) / width;
    return 2 * rf(ab * ab, ac * ac, bc * bc);
}

// q < q_crit. Viete: sin(psi) = q/q_crit, cos(psi) = sqrt(-delta2)/q_crit, roots 1/3 + (2/3) cos(2 psi/3 + 2 pi n/3).
struct RealRoots {
    double minus_e1, e2, e3;
    double e21, e32, e31;           // differences
    double below_one2, below_one3;  // 1 - e2, 1 - e3
    double middle_rest;             // (e2 + e3)/2 - 2/3
    RealRoots(double q, double delta2) {
        const double psi = std::atan2(q, std::sqrt(-delta2));
        const double co = std::atan2(std::sqrt(-delta2), q);  // pi/2 - psi
        const double sine = std::sin(psi / 3);
        minus_e1 = 4.0 / 3.0 * std::sin((2 * M_PI + psi) / 3) * sine;
        e2 = 4.0 / 3.0 * std::sin((2 * M_PI - psi) / 3) * sine;
        below_one2 = 4.0 / 3.0 * square(std::sin((M_PI - psi) / 3));
        below_one3 = 4.0 / 3.0 * square(sine);
        e3 = 1 - below_one3;
        const double scale = 2 / std::sqrt(3.0);
        e21 = scale * std::sin(2 * psi / 3);
        e32 = scale * std::sin(2 * co / 3);
        e31 = scale * std::sin((M_PI + 2 * psi) / 3);
        middle_rest = -kTwoThirds * square(std::sin(co / 3));
    }
};

// Up to this part of |e1| the integrand in zeta itself is analytic in a circle three times as large: 1e-16.
constexpr double kDirectPart = 0.3;

// int_0^to dzeta / (sqrt P (q + sqrt P)) for to <= kDirectPart |e1|, where P stays near q^2.
double direct(double q, double to) {
    return PanelGauss::integrate(
        [q](double zeta) {
            const double root = std::sqrt(q * q - zeta * zeta * (1 - zeta));
            return 1 / (root * (q + root));
        },
        0.0, to);
}

// T of a ray that runs outward from zeta0, T = int_0^zeta0 dzeta / (sqrt P (q + sqrt P)), in the variable that makes the integrand
// regular: relative error 1e-14. Its nearest singularity, zeta = e1, lies 0.28 beyond the range at least.
// Two real roots near the range: e1 < 0 < e2 < e3, below = e2 - zeta0, gap = e3 - e2; e2 - zeta = gap sinh^2(w), e3 - zeta = gap cosh^2(w): dzeta / sqrt((e2-zeta)(e3-zeta)) = -2 dw.
double outward_delay_real(double q, double zeta0, double minus_e1, double e2, double below, double gap) {
    const double split = kDirectPart * minus_e1;
    if (zeta0 <= split) return direct(q, zeta0);
    const double from = std::asinh(std::sqrt(below / gap)), to = std::asinh(std::sqrt((e2 - split) / gap));
    return direct(q, split) + integrate_panels(
                                  [=](double w) {
                                      const double sh = std::sinh(w), ch = std::cosh(w),
                                                   first = std::sqrt(e2 - gap * sh * sh + minus_e1);
                                      return 2 / (first * (q + gap * sh * ch * first));
                                  },
                                  from, to);
}

// A conjugate pair re +- i im, beyond = zeta0 - re; zeta = re + im sinh(w): dzeta / |zeta - e2| = dw.
double outward_delay_pair(double q, double zeta0, double minus_e1, double re, double im, double beyond) {
    const double split = kDirectPart * minus_e1;
    if (zeta0 <= split) return direct(q, zeta0);
    return direct(q, split) + integrate_panels(
                                  [=](double w) {
                                      const double first = std::sqrt(re + im * std::sinh(w) + minus_e1);
                                      return 1 / (first * (q + im * std::cosh(w) * first));
                                  },
                                  std::asinh((split - re) / im), std::asinh(beyond / im));
}

class Flyby : public Orbit {
public:
    explicit Flyby(const SchwarzschildStart& start) : Orbit(start.zeta0), start_(start), roots_(start.q, start.delta2) {
        // zeta0 - (e2 + e3)/2 <= 0: e3 - zeta0 is a sum, e2 - zeta0 follows from P.
        f3_ = std::abs(start.beyond - roots_.middle_rest) + 0.5 * roots_.e32;
        f1_ = start.zeta0 + roots_.minus_e1;
        f2_ = start.root_p / f1_ * (start.root_p / f3_);
        fate_ = Fate::kEscaped;
        if (start.s > 0) {
            turn_ = roots_.e2;
            segment_ = turn_angle_ = to_turn(f1_, f2_, f3_);
            angle_ = segment_ + to_turn(roots_.minus_e1, roots_.e2, roots_.e3);
        } else {
            angle_ = from_infinity();
        }
    }
    double place_at(double angle) const override {
        const bool approaches = start_.s > 0 && angle <= segment_;
        if (approaches && !from_sky_) from_sky_ = from_infinity();
        return zeta_from_infinity(approaches ? *from_sky_ + angle : angle_ - angle);
    }
    double delay() const override;

private:
    double from_infinity() const {
        return angle_between_points({f1_, f2_, f3_}, {roots_.minus_e1, roots_.e2, roots_.e3}, start_.zeta0);
    }
    // Swept between the point with these factors |zeta - e_i| and e2: s = 1/(e2 - zeta) gives R_F directly.
    double to_turn(double f1, double f2, double f3) const {
        return 2 * std::sqrt(f2) * rf(roots_.e21 * roots_.e32, f1 * roots_.e32, f3 * roots_.e21);
    }
    // zeta after the angle x from infinity, up to the turning point: Biermann and Weierstrass' formula from zeta = 0,
    //     2 zeta = [-q p'(x) + q^2/4] / (p(x) + 1/12)^2,  p = e3/4 - 1/12 + (e31/4) cs^2(sqrt(e31) x / 2):
    // every term is positive.
    double zeta_from_infinity(double x) const {
        const double omega = std::sqrt(roots_.e31);
        if (!jacobi_) jacobi_.emplace(roots_.e32 / roots_.e31);
        const JacobiValues j = (*jacobi_)(0.5 * omega * x);
        const double denominator = roots_.e3 * square(j.sn) + roots_.e31 * square(j.cn);
        const double numerator = omega * roots_.e31 * j.cn * j.dn * j.sn + start_.q * square(square(j.sn));
        return 2 * start_.q * numerator / square(denominator);
    }
    SchwarzschildStart start_;
    RealRoots roots_;
    double f1_, f2_, f3_, segment_ = 0;
    mutable std::optional<Jacobi> jacobi_;  // once places are asked for
    mutable std::optional<double> from_sky_;
};

// Inward part: 2 int_zeta0^e2 q dzeta / (zeta^2 (1 - zeta) sqrt P), from
//     1/(zeta^2 (1-zeta)) = 1/zeta^2 + 1/zeta + 1/(1-zeta),  d(sqrt P / zeta) = (-q^2/zeta^2 + zeta/2) dzeta / sqrt P:
//     2 [root_p/(q zeta0) + I_1/(2q) + q (Pi_0 + Pi_1)],
// I_1, Pi_0, Pi_1: integrals of zeta, 1/zeta, 1/(1-zeta) over dzeta / sqrt P.
// The substitution s = 1/(e2 - zeta) turns them into R_D and R_J.
double Flyby::delay() const {
    const RealRoots& e = roots_;
    double inward = 0;
    if (start_.s > 0) {
        const double product = e.e21 * e.e32, first = f1_ * e.e32, third = f3_ * e.e21;
        const double weight = 2.0 / 3.0 * product * f2_ * std::sqrt(f2_);
        const double i1 = e.e2 * segment_ - weight * rd(first, third, product);
        const double pi0 =
            segment_ / e.e2 + weight / square(e.e2) * rj(product, first, third, product * start_.zeta0 / e.e2);
        const double pi1 =
            segment_ / e.below_one2 -
            weight / square(e.below_one2) * rj(product, first, third, product * start_.lapse2 / e.below_one2);
        inward = start_.root_p / (start_.q * start_.zeta0) + i1 / (2 * start_.q) + start_.q * (pi0 + pi1);
    }
    return 2 * inward + outward_delay_real(start_.q, start_.zeta0, e.minus_e1, e.e2, f2_, e.e32);
}

// Between the photon sphere and the singularity, q < q_crit: rises to the turning point e3 at most.
class Inner : public Orbit {
public:
    explicit Inner(const SchwarzschildStart& start) : Orbit(start.zeta0), start_(start), roots_(start.q, start.delta2) {
        f2_ = std::abs(start.beyond - roots_.middle_rest) + 0.5 * roots_.e32;
        f1_ = start.zeta0 + roots_.minus_e1;
        f3_ = start.root_p / f1_ * (start.root_p / f2_);
        segment_ = from_turn({f1_, f2_, f3_});
        const Factors horizon{1 + roots_.minus_e1, roots_.below_one2, roots_.below_one3};
        const bool inside = start.lapse2 <= 0;
        if (start.s > 0) {
            if (inside) return;  // falls from the start: no sky, no end on the horizon
            fate_ = Fate::kCaptured;
            angle_ = angle_between_points(horizon, {f1_, f2_, f3_}, start.lapse2);
        } else {
            fate_ = inside ? Fate::kNoSky : Fate::kCaptured;
            turn_ = roots_.e3;
            turn_angle_ = segment_;
            angle_ = segment_ + from_turn(horizon);
        }
    }
    // From the turning point: zeta = e3 + e32 sc^2(sqrt(e31) v / 2).
    // From the singularity:   zeta = e3 + e31 cs^2(sqrt(e31) y / 2).
    double place_at(double angle) const override {
        if (!jacobi_) jacobi_.emplace(roots_.e32 / roots_.e31), to_singularity_ = to_singularity();
        const double v = std::abs(angle + start_.s * segment_), y = to_singularity_ - start_.s * angle;
        const double half = 0.5 * std::sqrt(roots_.e31);
        if (y > 0 && y < v) {
            const JacobiValues j = (*jacobi_)(half * y);
            return roots_.e3 + roots_.e31 * square(j.cn / j.sn);
        }
        const JacobiValues j = (*jacobi_)(half * v);
        return roots_.e3 + roots_.e32 * square(j.sn / j.cn);
    }
    double delay() const override { return kNotANumber; }

private:
    double from_turn(const Factors& f) const {
        return 2 * std::sqrt(f.c) * rf(roots_.e32 * roots_.e31, roots_.e31 * f.b, roots_.e32 * f.a);
    }
    double to_singularity() const { return 2 * rf(f1_, f2_, f3_); }
    SchwarzschildStart start_;
    RealRoots roots_;
    double f1_, f2_, f3_, segment_;
    mutable std::optional<Jacobi> jacobi_;
    mutable double to_singularity_ = 0;  // with it
};

// sinh(asinh(x) / 3). A logarithm turned back into a power would cost ln(x) roundings where x is large: a cube root does not.
double sinh_third(double x) {
    if (x < 1) return std::sinh(std::asinh(x) / 3);
    const double root = std::cbrt(x + std::hypot(x, 1.0));
    return 0.5 * (root - 1 / root);
}

// q > q_crit: psi = pi/2 + i eta, sinh(eta) = sqrt(delta2)/q_crit; one real root and the pair re +- i im.
class Passing : public Orbit {
public:
    explicit Passing(const SchwarzschildStart& start) : Orbit(start.zeta0), start_(start) {
        const double sinh_half = sinh_third(std::sqrt(start.delta2) / kCritical), half2 = square(sinh_half);  // of u/2
        const double cosh_u = 1 + 2 * half2, sinh_u = 2 * sinh_half * std::sqrt(1 + half2);
        minus_e1_ = (1 + 4 * half2) / 3;
        re_ = (2 + 2 * half2) / 3;
        im_ = sinh_u / std::sqrt(3.0);
        const double rest = kTwoThirds * half2;  // re - 2/3
        camera_ = point(start.zeta0, start.beyond - rest);
        sky_ = point(0, -re_);
        modulus_ = std::hypot(cosh_u, im_);  // |e1 - e2|
        m1_ = square(sinh_u) / (6 * modulus_ * (modulus_ + cosh_u));
        if (start.s < 0) {
            fate_ = Fate::kEscaped;
            angle_ = between(camera_, sky_, start.zeta0);
        } else if (start.lapse2 > 0) {
            fate_ = Fate::kCaptured;
            angle_ = between(point(1, 1.0 / 3.0 - rest), camera_, start.lapse2);
        }
    }
    // Biermann and Weierstrass' formula from infinity (zeta = 0) or from the singularity (the pole of the Weierstrass
    // function), whichever is nearer: p(x) = (e1 - 1/3)/4 + (N/4) (1 + cn)/(1 - cn), cn of sqrt(N) x, N = |e1 - e2|.
    double place_at(double angle) const override {
        const bool out = start_.s < 0;
        if (!jacobi_) {
            jacobi_.emplace(m1_), to_singularity_ = to_singularity(camera_);
            if (!out) from_sky_ = between(camera_, sky_, start_.zeta0);
        }
        const double x = out ? angle_ - angle : from_sky_ + angle;
        const double y = to_singularity_ + (out ? angle : -angle);
        const JacobiValues j = (*jacobi_)(std::sqrt(modulus_) * std::min(x, y));
        const double up = square(1 + j.cn), sn2 = square(j.sn);
        if (y < x) return modulus_ * up / sn2 - minus_e1_;
        const double numerator = 2 * modulus_ * std::sqrt(modulus_) * j.sn * j.dn * up + start_.q * square(sn2);
        return 2 * start_.q * numerator / square(modulus_ * up - minus_e1_ * sn2);
    }
    double delay() const override {
        if (fate_ != Fate::kEscaped) return kNotANumber;
        return outward_delay_pair(start_.q, start_.zeta0, minus_e1_, re_, im_, camera_.over);
    }

private:
    // zeta - e1, zeta - re, |zeta - e2|.
    struct Point {
        double f1, over, pair;
    };
    Point point(double zeta, double over) const { return {zeta + minus_e1_, over, std::hypot(over, im_)}; }
    // DLMF 19.29.4 with a conjugate pair of factors, sqrt(zeta - e2) = |.| exp(i a) at both ends: cos_half and sin_half
    // are those of the difference of the two a.
    double between(const Point& x, const Point& y, double width) const {
        if (width == 0) return 0;
        const double norm = x.pair * y.pair, sine = im_ * width / norm, cosine = (x.over * y.over + im_ * im_) / norm;
        const double large = std::sqrt(0.5 * (1 + std::abs(cosine))), small = 0.5 * sine / large;
        const double cos_half = cosine >= 0 ? large : small, sin_half = cosine >= 0 ? small : large;
        const double rx = std::sqrt(x.f1), ry = std::sqrt(y.f1), root = std::sqrt(norm);
        const double w = (x.pair * ry + y.pair * rx) / width;
        return 2 * rf_pair(w, root * (rx + ry) * cos_half / width, root * sin_half / (rx + ry));
    }
    double to_singularity(const Point& p) const {
        const double large = std::sqrt(0.5 * (p.pair + std::abs(p.over))), small = 0.5 * im_ / large;
        return 2 * rf_pair(std::sqrt(p.f1), p.over >= 0 ? large : small, p.over >= 0 ? small : large);
    }
    SchwarzschildStart start_;
    double minus_e1_, re_, im_, modulus_, m1_;
    Point camera_, sky_;
    mutable std::optional<Jacobi> jacobi_;  // once places are asked for, and with it
    mutable double to_singularity_ = 0, from_sky_ = 0;
};

// L = 0, and the circular orbit on the photon sphere, which never ends, stand.
std::unique_ptr<Orbit> make_schwarzschild_orbit(const SchwarzschildStart& given) {
    SchwarzschildStart start = given;
    if (!(start.q < kRadialQ))
        return std::make_unique<StandingOrbit>(start.zeta0, start.s < 0        ? Fate::kEscaped
                                                            : start.lapse2 > 0 ? Fate::kCaptured
                                                                               : Fate::kNoSky);
    if (start.delta2 == 0 && start.root_p == 0) return std::make_unique<StandingOrbit>(kTwoThirds, Fate::kNoSky, false);
    // The critical ray itself never ends; its neighbour, closer than any double q comes, does.
    if (start.delta2 == 0) start.delta2 = kNearlyCritical2;
    if (start.delta2 > 0) return std::make_unique<Passing>(start);
    if (start.beyond < 0) return std::make_unique<Flyby>(start);
    return std::make_unique<Inner>(start);
}

double delta2_of(double q) { return ((q - kCritical) - kCriticalRest) * (q + kCritical); }

// q^2 - zeta^2 (1 - zeta) with an error of 1e-32 q^2: products and sums carry their rounding errors along.
double orbit_polynomial(double q, double zeta) {
    const double q2 = q * q, q2_rest = product_rest(q, q, q2);
    const double z2 = zeta * zeta, z2_rest = product_rest(zeta, zeta, z2);
    const double a = 1 - zeta, part = a - 1, a_rest = (1 - (a - part)) + (-zeta - part);
    const double v = z2 * a, v_rest = product_rest(z2, a, v) + (z2_rest * a + z2 * a_rest);
    return (q2 - v) + (q2_rest - v_rest);
}

// From local directions: zeta0 = 1/r, 1 - zeta0 = (r-1)/r, zeta0 - 2/3 = (3-2r)/(3r); delta2 either from q or, near the
// photon sphere, from P - D^2 (zeta0 + 1/3) as a product, whichever cancels less.
SchwarzschildStart start_at(double r, double q, double root_p, int s) {
    SchwarzschildStart start{q, 1 / r, s, root_p, 0, (3 - 2 * r) / (3 * r), (r - 1) / r};
    const double hill = std::abs(start.beyond) * std::sqrt(start.zeta0 + 1.0 / 3.0);
    const bool near = root_p * root_p + hill * hill < 0.25 * kCritical * kCritical;
    start.delta2 = near ? (root_p - hill) * (root_p + hill) : delta2_of(q);
    return start;
}

class Schwarzschild : public OrbitMetric {
public:
    std::optional<double> horizon_radius() const override { return 1.0; }
    double lapse(double r) const override { return std::sqrt((r - 1) / r); }
    double lapse2_slope(double r) const override { return 1 / (r * r); }
    double kepler_rate(double r, double sense) const override {
        return sense * std::sqrt(0.5 / r) / r;
    }  // Kepler's third law, exactly
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const double q = std::max(ray.q, kLeastQ), zeta0 = ray.zeta0;
        double p = 0, delta2 = 0;
        if (q < kRadialQ) {
            p = orbit_polynomial(q, zeta0);
            delta2 = delta2_of(q);
            if (p < -kTurningSlack * q * q) {
                return no_such_ray(ray, "zeta0", ": q^2 < zeta0^2 (1 - zeta0)");
            }
        }
        const double beyond = (zeta0 - kTwoThirds) - kTwoThirdsRest;
        return make_schwarzschild_orbit({q, zeta0, ray.s, std::sqrt(std::max(p, 0.0)), delta2, beyond, 1 - zeta0});
    }
    // n = (n_r, n_t): E = sqrt(A), L = r n_t for unit frequency at the camera, sqrt(P) = q |n_r|.
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const double q = std::max(lapse(ray.r) / (ray.r * ray.n_t), kLeastQ);
        return make_schwarzschild_orbit(start_at(ray.r, q, q * std::abs(ray.n_r), ray.n_r <= 0 ? 1 : -1));
    }
    RainOrbit from_rain(const LocalRay& ray) const override {
        const double w = std::sqrt(1 / ray.r);
        const auto [energy, outward] = RainStart<double>(ray, w, (1 - ray.r) / (ray.r * (1 + w)));
        if (!(energy > 0))
            return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};  // never came from a sky
        const double q = std::max(energy / (ray.r * ray.n_t), kLeastQ), root_p = std::abs(outward) / (ray.r * ray.n_t);
        return {make_schwarzschild_orbit(start_at(ray.r, q, root_p, outward > 0 ? -1 : 1)), 1 / energy};
    }
};

}  // namespace

OrbitMetricPtr make_schwarzschild_orbits(const SpacetimeSpec&) { return std::make_unique<Schwarzschild>(); }

}  // namespace nullscope::reference
