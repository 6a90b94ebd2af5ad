// What matter emits and absorbs that is known by its density, temperature, magnetic field and motion, for the reference: four-vectors in
// the metric's own components, synchrotron radiation in cgs units.
#pragma once
#include <array>
#include <optional>

#include "base/vec.h"
#include "reference/electron_light.h"
#include "reference/metric.h"
#include "scene/scene.h"

namespace nullscope::reference {

// What the camera gets of light and what is lost of what is behind.
struct MatterLight {
    Vec3 light;
    double through;
};

struct MatterState {
    double density, temperature_K, field_G;
    Vec3 field_way;  // of kFile: the field's direction
    Vec3 velocity;   // four-velocity's along e_r, e_theta, e_phi of the observer of no angular momentum
};

class Emission {
public:
    explicit Emission(const Scene& scene);  // of a scene with a medium
    // Along one node. energy, momentum: of a photon of unit frequency in the camera; r_s.
    MatterLight at(const MatterState& matter, const PlaceMetric& g, const MediumNode& node, double energy,
                   double momentum) const;

private:
    // Frequency of that photon where the matter rests, and the cosine of its angle to the field.
    struct Seen {
        double frequency, cosine;
    };
    Seen seen(const MatterState& matter, const PlaceMetric& g, const MediumNode& node, double energy,
              double momentum) const;
    struct Coefficients {
        double emissivity, absorptivity;  // erg/(s cm^3 Hz sr), 1/cm
    };
    // nu: where the matter rests, Hz; cosine: of the light's angle to the field there.
    Coefficients coefficients(const MatterState& matter, double nu, double cosine) const;
    MediumSpec spec_;
    LightSpec light_;
    double length_cm_ = 0;                           // r_s
    std::optional<SynchrotronElectrons> electrons_;  // that are not thermal
    double opacity_ = 1;                             // of a black body for each r_s where the density is 1
    double unit_light_ = 1, unit_cgs_ = 1;
};

// K_2(x), x above 0; to 1e-12.
double bessel_k2(double x);
// Thermal synchrotron emissivity of electrons, erg/(s cm^3 Hz sr): in a field at an angle to the light (Leung, Gammie and Noble 2011,
// ApJ 737, 21), and the mean over all angles (Mahadevan, Narayan and Yi 1996, ApJ 465, 327). field: G; nu in Hz.
double synchrotron_at(double electrons, double temperature_K, double field, double sine, double nu);
double synchrotron_mean(double electrons, double temperature_K, double field, double nu);
double planck(double temperature_K, double nu);  // erg/(s cm^2 Hz sr)

}  // namespace nullscope::reference
