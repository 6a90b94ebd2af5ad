// Synchrotron light of electrons of a power law or a kappa distribution, and what they absorb and turn of it, for the reference: integrals over their
// energies of what ultrarelativistic electrons emit (Westfold 1959, ApJ 130, 241; V: Legg and Westfold 1968, ApJ 154, 499); absorption and Faraday's
// rotation and conversion by the derivative of the distribution, with the jumps at its ends. Cgs, in the frame of the matter; Q along the electric
// vector across the field, V > 0 turning from right to up as the camera sees it.
#pragma once
#include <array>
#include <cstddef>
#include <memory>

#include "scene/medium_spec.h"

namespace nullscope::reference {

struct ElectronLight {
    double emissivity, absorptivity;  // erg/(s cm^3 Hz sr), 1/cm
    double emitted_q, emitted_v;      // over the emissivity
    double absorbed_q, absorbed_v;    // over the absorptivity
    double conversion, rotation;      // rho_Q, rho_V, 1/cm
};

class SynchrotronElectrons {
public:
    // electrons: not thermal. isotropic: the mean over a field of every direction, of which Q, V and Faraday's are 0. Some 0.2 s.
    SynchrotronElectrons(const ElectronSpec& electrons, bool isotropic);
    // density: electrons a cm^3; field in G; cosine: of the angle between the light and the field; nu in Hz.
    ElectronLight at(double density, double temperature_K, double field, double cosine, double nu) const;

private:
    struct Tables;
    ElectronSpec spec_;
    bool isotropic_;
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nullscope::reference
