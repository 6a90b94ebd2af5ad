// Elliptic integrals and functions in the forms the orbits need: every argument is a quantity that the caller can form
// without cancellation, so every result is good to a few units in the last place, also next to the critical ray.
#pragma once
#include <array>

namespace nullscope::reference {

// Carlson's symmetric integrals (Boost.Math); a non-finite result instead of an exception outside their domain.
// rf, rj, rd: x, y, z >= 0, at most one of x, y, z zero (rd: z > 0), p > 0.
double rf(double x, double y, double z);
double rd(double x, double y, double z);
double rj(double x, double y, double z, double p);

// R_F(w^2, u^2, conj(u)^2) with w >= 0, u = re + i im, re >= 0. Taking the roots lets the first duplication step be
// done as a product: u^2 may lie on the negative real axis up to a tiny angle (a ray close to the critical one).
double rf_pair(double w, double re, double im);

// The three values sn, cn, dn of argument z for the complementary parameter m1 = 1 - k^2 in (0, 1]; |z| <= K.
// Relative accuracy of all three, also of cn near z = K and for m1 -> 0 (Bulirsch, Numer. Math. 7, 78 (1965)).
struct JacobiValues {
    double sn, cn, dn;
};
class Jacobi {  // of one parameter, for any number of arguments
public:
    explicit Jacobi(double m1);
    JacobiValues operator()(double z) const;

private:
    static constexpr int kMeanSteps = 16;           // of Gauss' mean: some 5 of them, and more as m1 -> 0
    std::array<double, kMeanSteps> upper_, lower_;  // as many as there are steps
    double mean_ = 1;
    int steps_ = 0;
};
inline JacobiValues jacobi(double z, double m1) { return Jacobi(m1)(z); }

}  // namespace nullscope::reference
