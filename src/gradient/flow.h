// The equations of a light ray, traced backward in time from its camera, in dual numbers: each step carries the derivatives by what the ray
// begins with and by the metric's numbers (the variational equations). No tables; shares no code with the shader nor with the reference.
//
// In Mino's time lambda (d(affine parameter) = Sigma dlambda), with u = 1/r and the unit vector n of the angles (theta, psi):
//     u' = w,  w' = U'(u)/2,  n'' = -(C + 2 b cos^2 theta) n + b cos(theta) z,  U = w^2,
// of the same form for all metrics here, regular at turning points and on the axis. b = a^2 E^2, C = |n'|^2 - b cos^2(theta): separated by
// Carter, Phys. Rev. 174, 1559 (1968); without rotation b = 0 and n moves on a great circle. The azimuth is psi and what the hole drags.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "base/vec.h"
#include "gradient/dual.h"

namespace nullscope {

// What rays are differentiated by: of a static observer at r, theta, who looks along n: r and theta (n kept in the local frame), and n turned
// by a small angle towards `aside` and towards `across`; the metric's numbers; how the disc leans.
enum Seed { kSeedR, kSeedTheta, kSeedAside, kSeedAcross, kSeedSpin, kSeedCharge, kSeedTilt, kSeedNode, kSeeds };
using Number = Dual<double, kSeeds>;

// n, over the local axes outward, southward, eastward, and two unit vectors across it.
struct LookedAlong {
    Vec3 n, aside, across;
};
LookedAlong looked_along(Vec3 n);

using Triple = std::array<Number, 3>;
// n of unit length, which kSeedAside and kSeedAcross turn.
Triple turning(const LookedAlong& view);

// view: n as an observer without angular momentum has it, whatever its derivatives.
struct Launch {
    Launch(double radius, double polar, double azimuth, const LookedAlong& along)
        : Launch(radius, polar, azimuth, turning(along)) {}
    Launch(double radius, double polar, double azimuth, const Triple& along)
        : r(radius), theta(polar), phi(azimuth), view(along) {}
    double r, theta, phi;
    Triple view;
};

inline Number dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

enum FlowState { kU, kW, kN, kTurn = kN + 3, kDragged = kTurn + 3, kTime, kFlowStates };  // kN, kTurn: n and n'
using RayState = std::array<Number, kFlowStates>;

// Of one ray: what stays the same along it. The photon has frequency 1 in the camera; energy E and momentum L = L_z at infinity.
struct Photon {
    Number energy, momentum, bent;  // bent: C; about a spherical hole L^2 of its plane
    // Products of these that slopes about a hole take: a (a E - L), K, (a E)^2, a^2 E.
    Number bend, carter, pull, swept;
};

// Of the metric at theta = pi/2 as a function of r, with its first three derivatives by r.
using OnceBent = Dual<Number, 1>;
using TwiceBent = Dual<OnceBent, 1>;
using ThriceBent = Dual<TwiceBent, 1>;
struct EquatorNumbers {
    ThriceBent tt, tphi, phiphi;
};
// g_tt, ...; elsewhere.
struct PlaceNumbers {
    Number tt, tphi, phiphi, thetatheta, rr;
};

class Flow {
public:
    virtual ~Flow() = default;
    // Where there is no observer at rest the state is not finite.
    virtual Photon launch(const Launch& from, RayState& state) const = 0;
    // time: T' = d(t + r_*)/dlambda of the light, as it runs: what the advanced time grows by. leaves: in the form for w < 0, without
    // cancellation far out; one form for a step, since they are equal only where U = w^2 to the last digit.
    virtual RayState slope(const Photon& photon, const RayState& state, bool leaves) const = 0;
    virtual Number radial(const Photon& photon, const Number& u) const = 0;  // U
    virtual double innermost() const = 0;  // u at the horizon, or where to stop looking for one
    virtual bool has_horizon() const = 0;
    virtual EquatorNumbers equator(const ThriceBent& r) const = 0;
    virtual PlaceNumbers place(const Number& r, const Number& cosine) const = 0;
    virtual Number spin() const { return Number(0.0); }  // a, r_s
};

// Schwarzschild's, Reissner and Nordstrom's, Kerr's, Kerr and Newman's, flat space and formulas. parameters: of the registry.
// Errors: another metric; a formula at fault.
Result<std::unique_ptr<Flow>> make_flow(const std::string& metric, const std::map<std::string, double>& parameters,
                                        const std::map<std::string, std::string>& formulas);

// mass 0: flat space. spin: a/M, charge: Q/M; derivatives by them are by these.
std::unique_ptr<Flow> make_hole_flow(double mass, double spin, double charge);
Result<std::unique_ptr<Flow>> make_formula_flow(const std::map<std::string, std::string>& formulas,
                                                std::optional<double> horizon);

// cos(theta), sin(theta) and the frame n, e_theta, e_phi at the launch, of dual theta; v = the view, of dual angles.
struct LaunchFrame {
    Number r, sine, cosine;
    Triple outward, southward, eastward, view;
    explicit LaunchFrame(const Launch& from);
};
// u, w and n'; what is dragged and the time begin at 0.
RayState launched(const LaunchFrame& frame, const Number& w, const Number& southward, const Number& eastward);

}  // namespace nullscope
