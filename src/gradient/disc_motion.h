// The matter of a disc and what accretion heats it with, in dual numbers: circular geodesics by the metric at the equator and its derivatives by r, and
// within the last stable circle the fall that keeps its constants (J. M. Bardeen, W. H. Press and S. A. Teukolsky, ApJ 178, 347 (1972)). About a rotating
// hole a disc may lean (scene/leaning_disc.h).
#pragma once
#include <vector>

#include "gradient/ray_gradient.h"
#include "scene/disc_plane.h"

namespace nullscope {

class DiscMotion {
public:
    // flow: outlives this. sense: 1 towards growing phi, -1 towards falling phi. A millisecond.
    DiscMotion(const Flow& flow, double sense, const DiscLean& lean);
    // Frequency in the camera (an observer without angular momentum) over frequency in the matter. Outside the horizon; some 20 microseconds.
    Number g(const Photon& photon, const RayGradient::Crossing& at) const;
    // Of the last stable circle, r_s; 0 without a horizon, where all are stable here.
    const Number& innermost() const { return innermost_; }

    struct Circle {
        TwiceBent rate, u_t, energy, momentum;  // with derivatives by r
    };
    Circle circle(const Number& r) const;  // not a number where there is none

private:
    void find_innermost();
    Number leaning_g(const Photon& photon, const RayGradient::Crossing& at) const;
    Number falling_g(const Photon& photon, const RayGradient::Crossing& at) const;
    const Flow& flow_;
    double sense_;
    DiscLean lean_;
    Number innermost_;
};

// Page and Thorne's flux (ApJ 191, 499 (1974), eq. 11b) per unit of accretion rate, 1/r_s^2:
//     -Omega'/(4 pi r (E - Omega L)^2) int (E - Omega L) L' dr from the last stable circle.
// The integral is kept by Chebyshev's polynomials of ln r: 1e-12.
class AccretionHeat {
public:
    // motion: outlives this, has a last circle. outer: to which it is asked for, r_s. Some 20 milliseconds.
    AccretionHeat(const DiscMotion& motion, double outer);
    Number flux(const Number& r) const;           // 0 within the last circle
    const Number& peak() const { return peak_; }  // the largest

private:
    Number depth(const Number& r) const;  // Chebyshev's variable, [-1, 1]
    const DiscMotion& motion_;
    double outer_;
    std::vector<Number> terms_;
    Number peak_;
};

}  // namespace nullscope
