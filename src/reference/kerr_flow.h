// Hamilton's equations of light about a rotating hole (kerr_chart.h), in variables that are smooth all the way from the
// hole to infinity, and no place far away has to be known for: a step there may be as long as the whole way.
//
// With x = n/u, n a unit vector, the state is n, the angular momentum J = x cross p, u, the radial momentum c = n p, and
// a clock; p = c n + u J cross n. The independent variable s is the affine parameter by d lambda = ds/u^2. In flat space
//     n' = J cross n,     J' = 0,     u' = -c,     c' = J^2 u,
// an oscillation with constant coefficients. What the hole adds is formed from H, l and their gradients at fixed p as
// kerr_chart.h has them, and whatever cancels is left out by hand, so that nothing is a difference that is divided by u:
// with l = (r x + a x cross e + (a^2 z/r) e)/(r^2 + a^2), e along the axis, and l p = (r x p - a J e + a^2 z p_z/r)/
// (r^2 + a^2), the torque is all across the axis: J_z is a constant, of which no more is made (no constant of Carter, no
// potentials of r and theta).
//
// No function but the square root, and no branch: of lanes of numbers as well as of one (lanes.h).
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "reference/kerr_chart.h"
#include "reference/lanes.h"

namespace nullscope::reference {

// n_x, n_y, n_z, J_x, J_y, u, c, clock
inline constexpr std::size_t kFlowSize = 8;
template <class Real>
using FlowState = std::array<Real, kFlowSize>;

// What the clock counts. Near the hole the chart's time t. Far away that grows as 1/u^2 and is smooth in nothing; but
//     energy t - x p = - integral of x force d lambda,
// by Hamilton's equations and p^2 = energy^2 + 2 H (l p)^2, without a difference. Light that moves outward in time
// has twice energy ln u of that left, which is not smooth either. The clock is
//     t;     energy t - x p;     energy t - x p + 2 energy ln u.
enum class FlowClock { kNear, kFar, kFarLogarithm };

// What does not change along a step.
template <class Real>
struct FlowRay {
    Real energy, j_z;
    Real far, logarithm;  // 0 or 1, by FlowClock
};

struct KerrFlow {
    double a, charge2;
    explicit KerrFlow(const KerrHole& hole) : a(hole.a), charge2(hole.charge2) {}

    // r |x|^-1, and Sigma/|x|^2, of a direction n and of (a u)^2: roots of R^4 - (1 - A) R^2 - A n_z^2 = 0.
    template <class Real>
    struct Round {
        Real ratio, sigma;
    };
    template <class Real>
    static Round<Real> round(const Real& n_z, const Real& au2) {
        using std::sqrt;
        const Real flat = 1.0 - au2, part = au2 * n_z * n_z, root = sqrt(flat * flat + 4.0 * part);
        const Real outer = 0.5 * (flat + root), inner = 2.0 * part / (root - flat);
        return {sqrt(where_positive(flat, outer, inner)), root};
    }

    template <class Real>
    void slope(const FlowRay<Real>& ray, const FlowState<Real>& s, FlowState<Real>& d) const {
        const Real &nx = s[0], &ny = s[1], &nz = s[2], &jx = s[3], &jy = s[4], &jz = ray.j_z, &u = s[5], &c = s[6];
        const Real turn_x = jy * nz - jz * ny, turn_y = jz * nx - jx * nz, turn_z = jx * ny - jy * nx;  // J cross n
        const Real au2 = (a * u) * (a * u);
        const auto [ratio, sigma] = round(nz, au2);
        const Real over_ratio = 1.0 / ratio, over_sigma = 1.0 / sigma, w = nz * over_ratio;  // w = cos(theta)
        const Real across = 1.0 + au2 * w * w, over_across = 1.0 / across;                   // (r^2 + a^2)/|x|^2
        const Real charge = charge2 * u * over_ratio, twice_mass = 1.0 - charge;
        // 2 H = u g, d ln(twice_mass r^3)/d ln r = power
        const Real g = twice_mass * ratio * over_sigma, power = 3.0 + charge / twice_mass;
        const Real px = c * nx + u * turn_x, py = c * ny + u * turn_y, pz = c * nz + u * turn_z;
        const Real climb = (ratio * c - (a * jz) * (u * u) + au2 * w * pz) * over_across;  // l p
        const Real lp = ray.energy + climb, pull = g * lp;
        // d(H (l p)^2)/dr at fixed p and angles, over H l p u: twice beta
        const Real beta = lp * (0.5 * power * over_ratio - 2.0 * ratio * over_sigma) +
                          (c - au2 * w * pz * over_ratio - 2.0 * ratio * climb) * over_across;
        const Real drag = u * pull * over_across;
        const Real lift = (a * a) * u * w;
        d[0] = turn_x - drag * (a * ny - lift * nz * nx);
        d[1] = turn_y + drag * (a * nx + lift * nz * ny);
        d[2] = turn_z - drag * (lift * (1.0 - nz * nz));
        const Real along_n =
            (a * a) * (w * (beta * ratio - lp) * over_ratio * over_sigma + pz * over_ratio * over_across);
        const Real of_p = (a * a) * w * over_across, of_j = a * over_across;
        d[3] = u * pull * (of_p * py + along_n * ny - of_j * jy);
        d[4] = u * pull * (of_j * jx - of_p * px - along_n * nx);
        d[5] = u * pull * ratio - c;
        const Real j2 = jx * jx + jy * jy + jz * jz, aside = au2 * w * w * over_sigma;
        d[6] = j2 * u + pull * (beta * ratio * across * over_sigma + ratio * c - aside * lp);
        // -x force |x|/u, and what the logarithm adds
        const Real virial = pull * ((beta * ratio * across - au2 * w * w * lp) * over_sigma +
                                    (ratio * c - (a * jz) * (u * u) + au2 * w * pz) * over_across);
        const Real over_u = 1.0 / u;
        const Real near_rate = (ray.energy * over_u + pull) * over_u;
        const Real far_rate = ray.logarithm * (2.0 * ray.energy) * (pull * ratio - c * over_u) - virial * over_u;
        d[7] = (1.0 - ray.far) * near_rate + ray.far * far_rate;
    }
};

}  // namespace nullscope::reference
