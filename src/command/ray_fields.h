// A ray as it is written down: named fields, checked and made a RayQuery (docs/ray-data.md, "Rays in").
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "scene/ray.h"
#include "spacetime/spacetime.h"

namespace nullscope::cli {

enum RayColumn {
    kR,
    kTheta,
    kPhi,
    kNr,
    kNtheta,
    kNphi,
    kFrame,
    kQ,
    kZeta0,
    kS,
    kAtAngle,
    kAlpha,
    kBeta,
    kLambda,
    kEta,
    kUp,
    kUnit,
    kRayColumns
};
inline constexpr std::array<std::string_view, kRayColumns> kRayColumnNames = {
    "r", "theta",    "phi",   "n_r",  "n_theta", "n_phi", "frame", "q",   "zeta0",
    "s", "at_angle", "alpha", "beta", "lambda",  "eta",   "up",    "unit"};
inline constexpr std::string_view kRayForms =
    "r,theta,phi,n_r,n_theta,n_phi[,frame] or alpha,beta,theta[,phi,unit] or lambda,eta,theta[,up,phi,unit] or "
    "q,zeta0,s "
    "(wormholes: q,l0,s); each with at_angle";

inline constexpr bool is_word(RayColumn column) { return column == kFrame || column == kUnit; }  // others are numbers

// kAtInfinity: of an observer at infinity at theta and phi, as one that rests at kFarObserver: alpha, beta are off by 1/kFarObserver of themselves.
// kConserved: the same by what the photon conserves.
enum class RayForm { kGeneral, kAtInfinity, kConserved, kReduced };
inline constexpr double kFarObserver = 1e9;  // r_s

// The column of this name; nothing for others. Wormholes: l0 is zeta0's.
std::optional<RayColumn> ray_column(std::string_view name, const Spacetime& spacetime);

// The form of a ray that columns which are there make. Errors: some are missing, or of several forms; key: "header".
Result<RayForm> ray_form(const std::array<bool, kRayColumns>& there);

// The fields of one ray. All columns of its form are there.
class RayFields {
public:
    virtual bool given(RayColumn column) const = 0;                    // there, and not empty
    virtual std::optional<double> number(RayColumn column) const = 0;  // nothing: it is no finite number
    virtual std::string text(RayColumn column) const = 0;              // as it is written

protected:
    ~RayFields() = default;
};

// The view direction is normalised, lengths are in Spacetime::length_unit. Errors: the first fault, its column as key.
Result<RayQuery> ray_query(const RayFields& fields, RayForm form, const Spacetime& spacetime);

}  // namespace nullscope::cli
