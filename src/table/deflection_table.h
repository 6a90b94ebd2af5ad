// The deflection table: swept angle phi of every light ray of a static spherically symmetric spacetime with a photon sphere,
// indexed by (q, zeta0) through the shaped mapping of shaders/core/table_mapping.glsl. Built on the CPU, in parallel.
//
// phi = closed-form logarithm + R; the table holds the smooth remainder R. With c = cos(chi), h = sin(chi) G(c) and
// G = a0 + a1 c + a2 c^2 + a3 c^3 + ... about the photon sphere, k'^2 = 1 - k^2, t = k cos(alpha):
//   turning (k < 1): dphi = h dalpha / sqrt(k'^2 + t^2);
//       phi = a0 [asinh(k/k') - asinh(t/k')] + (a2/2) [F(k) - F(t)] + R,   F(t) = t sqrt(k'^2 + t^2) + k'^2 asinh(t/k')
//   through (k > 1): dphi = h dchi / sqrt(d^2 + c^2), d^2 = k^2 - 1;
//       phi = a0 J0 + a1 J1 + a2 J2 + a3 J3 + R/k,   Jn = integral of c^n / sqrt(d^2 + c^2) dc from cos(chi) to 1
// What is left of the singularity in R is O(k'^4 ln k').
// Where R_areal = l + ln l far out, R holds k ln k and alpha^2 ln alpha, which polynomials on even nodes follow to 7e-5 rad only: nodes
// are graded there and twice as many, which leaves kGradedError (tests/unit/test_deflection_table.cpp).
//
// Accuracy at the default size: 2e-9 rad (tests/unit/test_deflection_table.cpp). Build: some 30 core-milliseconds.
#pragma once
#include <vector>

#include "spacetime/spherical_metric.h"
#include "table/density_fit.h"

namespace nullscope {

class DeflectionTable {
public:
    static constexpr int kDefaultSize = 96;  // cells along x and along y

    // spacetime must have a photon sphere. size >= 8.
    explicit DeflectionTable(const SphericalMetric& spacetime, int size = kDefaultSize);

    // k = q/q_crit < 1 with one_minus_k2 = 1 - k^2 formed without cancellation; camera outside the photon sphere looking at
    // the angle alpha from the outward radial: angle swept until infinity. alpha in [0, pi].
    double turning_to_sky(double k, double one_minus_k2, double alpha) const {
        return turning(outer_, k, one_minus_k2, alpha);
    }
    // The same inside the photon sphere: angle swept until the horizon; beta = angle from the INWARD radial.
    double turning_to_horizon(double k, double one_minus_k2, double beta) const {
        return turning(inner_, k, one_minus_k2, beta);
    }
    // k > 1 with k2_minus_one = k^2 - 1: angle between infinity and the radius chi. chi in [0, pi].
    double through_from_infinity(double k, double k2_minus_one, double chi) const;

    // Of G about the photon sphere.
    struct Series {
        double a0, a1, a2, a3;
    };
    const Series& series() const { return series_; }
    // What method kTable adds to its own closed forms, at table coordinates x, y in [0, 1]: R of the turning branch outside the
    // photon sphere; k (phi - a0 J0 - a1 J1) of the through branch, without the terms that cancel in float.
    double turning_remainder(double x, double y) const { return outer_.at(x, y); }
    double through_remainder(double x, double y) const;
    int size() const { return size_; }
    std::size_t bytes() const;  // of the three branches as double

private:
    // Row-major values on a (size+1)^2 grid of nodes, x fastest... row = x index, column = y index.
    // Graded: nodes crowd towards k = 0 as a cube, towards both ends of the angle as another, for metrics with a logarithm there.
    struct Branch {
        int size = 0;
        bool graded_x = false, graded_y = false;
        std::vector<double> values;
        double node_x(int i) const;
        double node_y(int j) const;
        double at(double x, double y) const;  // 6x6-point Lagrange interpolation; x, y in [0, 1]
        template <class Row>
        void build(const Row& integrand_of);
    };
    void build_turning(const DensityFit& density, bool inner, Branch& branch);
    void build_through(const DensityFit& density, Branch& branch);
    double turning(const Branch& branch, double k, double one_minus_k2, double angle) const;

    int size_;
    Series series_;
    Branch outer_, inner_, through_;
};

}  // namespace nullscope
