#pragma once

namespace nullscope::reference {

// T of a ray that runs outward from zeta0, T = int_0^zeta0 dzeta / (sqrt P (q + sqrt P)): quadrature in the variable
// that makes the integrand regular, relative error 1e-14.
// Two real roots near the range: e1 < 0 < e2 < e3, below = e2 - zeta0, gap = e3 - e2.
double outward_delay_real(double q, double zeta0, double minus_e1, double e2, double below, double gap);
// A conjugate pair re +- i im; beyond = zeta0 - re.
double outward_delay_pair(double q, double zeta0, double minus_e1, double re, double im, double beyond);

}  // namespace nullscope::reference
