// Constants of electrons, cgs (CODATA 2018), and what follows for thermal ones in a magnetic field.
#pragma once
#include <cmath>

namespace nullscope::reference {

inline constexpr double kCharge = 4.80320471e-10, kLight = 2.99792458e10, kElectron = 9.1093837e-28,
                        kBoltzmann = 1.380649e-16, kPlanck = 6.62607015e-27;
// e B/(2 pi m c), Hz; field in G.
inline double gyro_frequency(double field) { return kCharge * field / (2 * M_PI * kElectron * kLight); }
// k T/(m c^2); K.
inline double theta_of(double temperature) { return kBoltzmann * temperature / (kElectron * kLight * kLight); }

}  // namespace nullscope::reference
