// The light of a thermal disc, found another way than the tables do: the metric's derivatives by r from Richardson's
// differences, Kepler's law g_phiphi' Omega^2 + 2 g_tphi' Omega + g_tt' = 0, the flux by adaptive quadrature, the shift
// from conserved E and L_z alone.
#pragma once
#include <array>
#include <vector>

#include "base/vec.h"
#include "reference/metric.h"
#include "reference/seen_light.h"
#include "scene/scene.h"

namespace nullscope::reference {

// What a photon brings to a ring: per unit of its energy at infinity.
struct PhotonAtDisc {
    double r;           // r_s
    double l_z;         // angular momentum about the disc's axis over energy, r_s
    double climb;       // as PlaneCrossing
    double cosine = 0;  // of theta, of a disc that leans about a rotating hole
    double across = 0;  // as PlaneCrossing; of such a disc
};

// Polarised fraction of what leaves an atmosphere of electrons that scatter by Thomson's law, across the normal, by the cosine of the angle to it;
// from the same functions as its limb darkening, 1e-9.
double scattered_fraction(double cosine);

class DiscLight {
public:
    // metric: outlives this. Some milliseconds.
    DiscLight(const Metric& metric, const DiscSpec& disc, const LightSpec& light);
    // Frequency at infinity over frequency in the matter, and its parts.
    double g_infinity(const PhotonAtDisc& photon) const;
    Shift shift(const PhotonAtDisc& photon) const;
    // Of the matter, contravariant; outside the horizon. Without Doppler at rest.
    struct Velocity {
        double t, r, phi;
    };
    Velocity velocity(double r) const;
    Velocity circling(double r) const;  // on the circular orbit there, stable or not
    // Flux per unit of accretion rate, 1/r_s^2; some 30 microseconds.
    double flux(double r) const;
    // What the disc shines by, over its largest value between the rims (of accretion: anywhere); from a table: 1e-8 of the largest, of lamps 1e-5.
    double heat(double r) const;
    double hottest_K() const { return disc_.temperature_K; }
    double innermost() const { return isco_; }   // stable circular orbit, r_s
    double hottest() const { return hottest_; }  // radius of the largest flux, r_s
    // Between the light and the disc's normal, in the matter's frame; without Doppler as matter at rest has it. Outside the horizon.
    double cosine(const PhotonAtDisc& photon) const;
    // Linear Rec. 709 of unit emissivity, over the luminance of the hottest ring in its own frame. g: camera/matter.
    Vec3 colour(const PhotonAtDisc& photon, double g) const;

private:
    struct Circle {
        double u_t, omega, energy, momentum;
    };
    using Circles = std::array<Circle, 9>;        // at a radius and beside it, to differentiate
    struct Ring {                                 // Page and Thorne's
        double gained;                            // of (E - Omega L) dL/dr, what those within it have to shed
        double gain, omega_slope;                 // E - Omega L; by r
        double shed(double sum, double r) const;  // flux, by the integral of `gained` up to it
    };
    Circle circle(double r) const;
    bool leans() const { return disc_.lean.tilt != 0 && metric_.a() != 0; }
    double apart(double r) const;  // of such, over r
    Circles circles(double r) const;
    Ring ring(double r) const;
    void tabulate_heat(double outer, double peak);
    void tabulate_emissivity();
    PhotonAtDisc met(const PhotonAtDisc& photon) const;  // as matter there meets it, with lensing or straight

    const Metric& metric_;
    DiscSpec disc_;
    LightSpec light_;
    double sense_;
    double isco_ = 0, hottest_ = 0, luminance_ = 1;
    std::vector<double> heat_;  // flux over the largest, at equal steps of ln(r/heated_)
    double step_ = 1, heated_ = 0;
};

}  // namespace nullscope::reference
