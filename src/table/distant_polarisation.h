// Linear polarisation of a disc's light as an observer at infinity sees it (shaders/core/polarisation.glsl, observer/screen_form.h).
//
// In Bardeen's coordinates (spectrum/distant_light.h) what the screen has of Walker and Penrose's constant is, up to a factor that counts for
// nothing, (alpha + a sin i) + i beta: the limit of the camera's far away.
#pragma once
#include <complex>
#include <functional>
#include <memory>
#include <optional>

#include "spacetime/spacetime.h"
#include "table/disc_light.h"

namespace nullscope {

// A photon of energy 1 at infinity: where the observer sees it, r_s; its Carter constant eta; p_r Delta/r^2 where it leaves the disc.
struct DistantPhoton {
    double alpha, beta, lambda, eta, slope;
};

class DistantPolarisation {
public:
    // inclination: rad from the axis, of an observer above the disc. field: its direction, unit, along r, azimuth and north, in the matter's frame. fraction: of
    // the light that is polarised; nothing: as an atmosphere that scatters. The spacetime has discs.
    DistantPolarisation(std::shared_ptr<const Spacetime> spacetime, double inclination, Vec3 field,
                        std::optional<double> fraction, Sense sense = Sense::kEastward);
    // Of light from this radius, outside of the horizon: Q + iU over I, angles from alpha towards beta.
    std::function<std::complex<double>(const DistantPhoton&)> ring(double r) const;

private:
    std::shared_ptr<const Spacetime> spacetime_;
    DiscMatterFlow flow_;
    double a_ = 0.0, shift_ = 0.0;  // shift: a sin i
    Vec3 field_;
    std::optional<double> fraction_;
};

}  // namespace nullscope
