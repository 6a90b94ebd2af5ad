// Scorer's function Gi for the reference: by Airy's functions and their integrals (NIST DLMF 9.12.4), beyond z = 10 by its asymptotic series (9.12.25).
#pragma once

namespace nullscope::reference {

struct Scorer {
    double value, slope;  // Gi(z), Gi'(z)
    double beyond;        // integral of pi Gi(t) - 1/t from z on
};
Scorer scorer(double z);  // z above 0; to 1e-8

}  // namespace nullscope::reference
