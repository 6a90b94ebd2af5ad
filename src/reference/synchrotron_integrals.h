// What one ultrarelativistic electron does to light of x = nu/nu_c, for the reference, and integrals of it over distributions of energies.
#pragma once
#include <array>

#include "scene/medium_spec.h"

namespace nullscope::reference {

// Integrals over u of a distribution f, dN/du = u^2 f, and of its derivative: u is gamma of a power law of one electron; of a kappa distribution
// u^2 f = u^2 (1 + u)^-(kappa + 1), u = gamma over its scale. x = s/u^2.
struct ElectronIntegrals {
    double emitted, emitted_q, emitted_v;     // of u^2 f times those of I and Q, and that of V over u
    double absorbed, absorbed_q, absorbed_v;  // of -u^2 df/du times the same
    double conversion;  // of -u^2 df/du times -pi sqrt(z) Gi'(z), times 0.75 s: at high frequencies of 2u u^2 f
    double rotation;    // of -u df/du, times what rotation by each lacks of ln(2 gamma) - 1 at high frequencies
};
ElectronIntegrals electron_integrals(const ElectronSpec& electrons, bool isotropic, double s);

// One electron: means of arccosh(gamma)/(gamma sqrt(gamma^2 - 1)) and of 1/gamma; of a kappa distribution with this w, whose
// gamma sqrt(gamma^2 - 1) (1 + (gamma - 1)/(kappa w))^-(kappa + 1) adds up to `sum`.
struct ElectronMeans {
    double rotation, inverse, sum;
};
ElectronMeans electron_means(const ElectronSpec& electrons, double w);

}  // namespace nullscope::reference
