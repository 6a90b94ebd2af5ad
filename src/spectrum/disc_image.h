// The direct image of a disc's rings, Luminet's isoradials (1979), for an observer at infinity: smooth functions of radius and of the angle round
// the image, from few traced rays.
//
//     alpha = rho cos(chi),   beta = sqrt(cos i) rho sin(chi),   y = ln(r - r_horizon).
// Light of rho = 0 comes along the axis and never crosses the plane; along each chi the radius of the ring that is seen grows with rho, from the
// horizon's image outward. ln rho is a trigonometric polynomial in chi and a polynomial in y, through equal angles and Chebyshev's nodes:
// each node more divides the error. The factor of beta shares out the angles between the near side of a disc that is seen at a slant,
// flattened by cos i, and its far side, which light bends up.
#pragma once
#include <vector>

#include "spectrum/distant_light.h"

namespace nullscope {

class DiscImage {
public:
    // Nodes in y and chi, and angles at which rings are asked for, a multiple of `angles`.
    struct Size {
        int radii, angles, columns;
    };
    // horizon < inner < outer. Some five rays a node. light outlives this.
    DiscImage(const DistantLight& light, double inner, double outer, Size size);

    // A ring's point at chi = 2 pi j/columns.
    struct Point {
        double alpha, beta;
        double area;   // d(alpha) d(beta) over dr d(chi), r_s
        double slope;  // of DistantLight::Crossing
    };
    // inner <= r <= outer. Microseconds a column and 100 radii.
    std::vector<Point> ring(double r) const;

private:
    const DistantLight* light_;
    double low_, high_, squash_;  // y of both ends; what beta is smaller by
    Size size_;
    std::vector<double> cosine_, sine_;  // of alpha and beta at every column
    std::vector<double> rho_,
        slope_;  // of ln rho and the slope: coefficients of Chebyshev's polynomials, in rows of columns
};

}  // namespace nullscope
