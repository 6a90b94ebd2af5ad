// Vectors at a place by components in ingoing coordinates (v, r, theta, phi~), in the Cartesian ones of carried_axes.h.
#pragma once
#include <complex>

#include "reference/carried_axes.h"

namespace nullscope::reference {

class CarryingPlace {
public:
    CarryingPlace(const CarryingMetric& metric, const Vec3& x);
    double r() const { return r_; }  // Boyer and Lindquist's, r_s
    Vec3 direction() const { return {sine_ * out_.real(), sine_ * out_.imag(), cosine_}; }  // of theta and phi~: unit
    double sine() const { return sine_; }
    double cosine() const { return cosine_; }
    double delta() const { return delta_; }
    FourVector ingoing(double v, double r, double theta, double phi) const;
    // By components of Boyer and Lindquist's t, r, theta, phi, without rotation Schwarzschild's.
    FourVector outer(double t, double r, double theta, double phi) const;
    double product(const FourVector& u, const FourVector& v) const { return metric_.product(x_, u, v); }

private:
    const CarryingMetric& metric_;
    Vec3 x_;
    double a_, r_, cosine_, sine_, delta_;
    std::complex<double> out_;  // e^(i phi~)
};

FourVector sum_of(double a, const FourVector& u, double b, const FourVector& v);
// With the matter u, after a boost without rotation from the observer e.
FourVector moved(const CarryingPlace& at, const FourVector& b, const FourVector& u, const FourVector& e);
// epsilon_abcd p^a u^b k^c f^d: these coordinates have the determinant -1.
double volume_of(const FourVector& p, const FourVector& u, const FourVector& k, const FourVector& f);

}  // namespace nullscope::reference
