// How matter shines, in dual numbers (docs/matter.md): thermal synchrotron light and bremsstrahlung in cgs units, in the frame of the matter. Shares no code
// with the reference nor with the shader.
#pragma once
#include "gradient/flow.h"

namespace nullscope::matter_law {

Number power(const Number& base, double exponent);  // base > 0
// ln(e^x K_2(x)), x > 0: 1e-12. A microsecond.
Number log_scaled_bessel_k2(const Number& x);

// Thermal electrons a cm^3, T in K, field in G, nu in Hz; erg/(s cm^3 Hz sr). In a field at an angle to the light (Leung, Gammie and Noble 2011, ApJ 737,
// 21), and the mean over all angles (Mahadevan, Narayan and Yi 1996, ApJ 465, 327). Colder than kColdest_K, or without a field: 0.
Number synchrotron_at(const Number& electrons, const Number& temperature, const Number& field, const Number& sine,
                      const Number& nu);
Number synchrotron_mean(const Number& electrons, const Number& temperature, const Number& field, const Number& nu);
// Of thermal electrons among as many protons (Rybicki and Lightman 1979, 5.14), Gaunt factor sqrt(3)/pi (17.7 + ln(T^1.5/nu)), at least 1.
Number bremsstrahlung(const Number& electrons, const Number& temperature, const Number& nu);
Number planck(const Number& temperature, const Number& nu);  // erg/(s cm^2 Hz sr)

}  // namespace nullscope::matter_law
