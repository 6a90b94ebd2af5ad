// Columns of the orbit table through a wormhole: where zeta = 1/R is no coordinate, being the same on both sides of the throat.
//
// Lengths over the throat's radius, L = l towards the sky where the ray ends. W, from 0 at that sky to pi at the other, is what texels
// hold in place of zeta:
//     L = cos W (1/sin W - mu ln sin W),   mu = M/rho where R = |L| - mu ln |L| + const far out (0 of Ellis' wormhole: L = cot W),
// so that W is as smooth in the swept angle as 1/R is, at either end, and l is a formula of W (shaders/planar/place.glsl). With
// D = dL/dW and q the inverse impact parameter,
//     (W')^2 = q^2 P^2 - Q^2,   P = R^2/D,   Q = R/D;   W'' = q^2 P P_W - Q Q_W:   regular at turning points, in throat and tube.
#pragma once
#include "table/met_orbit.h"
#include "table/ray_family.h"

namespace nullscope {

class ThroatShape {
public:
    explicit ThroatShape(const SphericalMetric& spacetime);
    double throat() const { return throat_; }
    double mu() const { return mu_; }
    double angle(double length) const;        // W of L
    double length(double angle) const;        // and back
    double length_slope(double angle) const;  // D
    double length_bend(double angle) const;   // dD/dW
    struct Force {
        double steep, flat;              // W'' = q^2 steep - flat
        double steep_slope, flat_slope;  // and by W
    };
    Force force(double angle) const;
    // |L| of the ends of the tube, where the forces have a corner; 0 in Ellis' wormhole.
    double rim() const { return rim_; }
    double flare() const { return flare_; }  // |L| beyond that over which R changes its course

private:
    const SphericalMetric& spacetime_;
    double throat_, mu_, rim_, flare_;
};

// Z = W/(1 - v) of all rays. Error of l against the reference: tests/unit/test_throat_orbit.cpp.
OrbitTexels throat_column(const RayFamily& family, Segment segment, double delta);

}  // namespace nullscope
