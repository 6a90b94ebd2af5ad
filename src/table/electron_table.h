// What electrons of a power law or a kappa distribution emit, absorb and turn of light, as the shader has it
// (shaders/medium/electron_table.glsl): integrals of table/synchrotron_kernels.h over their energies, of any frequency, below the light of the
// slowest electron and above that of the fastest too.
#pragma once
#include "light/electron_energies.h"
#include "table/strip.h"

namespace nullscope {

inline constexpr int kElectronRows = 3;
// Texels at the ends of electron_cells(), in three rows. With N(gamma) of one electron, of a kappa distribution u^2 (1 + u)^-(kappa + 1) of u,
// gamma over the scale kappa w - 1 (at least 1), instead:
//     log2 of J = integral of N i, log2 of A = integral of 2 N i_absorbed/gamma, the same integrals of q over these two;
//     log2 of those of v over these two; log2 of M = integral of 2 gamma N z^2/(1 + z^2), that of 2 gamma N converted over it;
//     integral of N turned/gamma^2; of the third row the rest is, of a kappa distribution by log2 w from kElectronColdest to kElectronHottest:
//     log2 of w^3 over its integral with 1 at gamma = 1, log2 of the means of arccosh(gamma)/(gamma sqrt(gamma^2 - 1)) and of 1/gamma.
// A field of every direction: J and A alone, of the means. Straight lines leave at most 1e-3 where it shines. Some 50 ms.
TexelGrid electron_texels(const ElectronEnergies& energies);

}  // namespace nullscope
