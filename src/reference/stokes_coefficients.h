// What thermal electrons in a magnetic field emit, absorb and turn of polarised light, for the reference: cgs, in the frame of the matter, Q along
// the electric vector across the field, V > 0 turning from right to up as the camera sees it. Emission by Kirchhoff's law absorption. Ratios of Q
// and V to I: Dexter 2016 (MNRAS 462, 115), A12 to A20; Faraday's: Shcherbakov 2008 (ApJ 688, 695) as Dexter corrects it, B4 to B15.
#pragma once

namespace nullscope::reference {

struct StokesCoefficients {
    double emitted_q, emitted_v;  // over I's
    double conversion, rotation;  // rho_Q, rho_V, 1/cm
};
// electrons a cm^3; field in G; cosine: of the angle between the light and the field; nu in Hz. faraday: whether the last two are asked for.
StokesCoefficients thermal_stokes(double electrons, double temperature_K, double field, double cosine, double nu,
                                  bool faraday);

}  // namespace nullscope::reference
