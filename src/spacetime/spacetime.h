// Spacetime: what the host needs to know of a static, spherically symmetric metric
//     ds^2 = -A dt^2 + dr^2/A + r^2 dOmega^2,   zeta = r_s/r,   units r_s = c = 1, signature (-,+,+,+).
//
// Light is governed by V(zeta) = A zeta^2 alone: (dzeta/dphi)^2 = q^2 - V with q = E r_s/L. Where there is a photon sphere,
// V = q_crit^2 sin^2(chi) defines the angle chi in [0, pi] (0 at infinity, pi/2 on the photon sphere, pi at the horizon) and
//     dphi = h(chi) dchi / sqrt(k^2 - sin^2 chi),   k = q/q_crit:
// the metric enters the deflection table only through the smooth function h.
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace nullscope {

struct PhotonSphere {
    double zeta;     // r_s / r of the unstable circular light orbit
    double q_crit;   // E r_s / L of the rays that spiral to it
};

using Matrix4 = std::array<std::array<double, 4>, 4>;

class Spacetime {
public:
    virtual ~Spacetime() = default;
    virtual std::string_view name() const = 0;
    // A = -g_tt. Any zeta >= 0; negative inside a horizon.
    virtual double lapse_squared(double zeta) const = 0;
    // d(A zeta^2)/dzeta / 2: the orbit equation is zeta'' = -half_v_slope(zeta).
    virtual double half_v_slope(double zeta) const = 0;
    virtual double half_v_curvature(double zeta) const = 0;   // its derivative
    // Outer horizon's radius in r_s; nothing if there is none.
    virtual std::optional<double> horizon_radius() const = 0;
    virtual std::optional<PhotonSphere> photon_sphere() const = 0;  // nothing: light runs straight (see bends_light)
    virtual bool bends_light() const = 0;
    // The angle chi of a radius and back; only where there is a photon sphere. Relative error < 1e-15 near zeta = 0.
    virtual double chi_from_zeta(double zeta) const = 0;
    virtual double zeta_from_chi(double chi) const = 0;
    virtual double bending_density(double chi) const = 0;  // h(chi), chi in [0, pi]

    // Covariant metric g_{mu nu} and its inverse in (t, r, theta, phi).
    Matrix4 metric(double r, double theta) const;
    Matrix4 inverse_metric(double r, double theta) const;
};

}  // namespace nullscope
