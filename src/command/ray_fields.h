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

enum RayColumn { kR, kTheta, kPhi, kNr, kNtheta, kNphi, kFrame, kQ, kZeta0, kS, kAtAngle, kRayColumns };
inline constexpr std::array<std::string_view, kRayColumns> kRayColumnNames = {
    "r", "theta", "phi", "n_r", "n_theta", "n_phi", "frame", "q", "zeta0", "s", "at_angle"};
inline constexpr std::string_view kRayForms =
    "r,theta,phi,n_r,n_theta,n_phi[,frame] or q,zeta0,s (wormholes: q,l0,s); either with at_angle";

// The column of this name; nothing for others. Wormholes: l0 is zeta0's.
std::optional<RayColumn> ray_column(std::string_view name, const Spacetime& spacetime);

// Whether columns that are there make the reduced form of a ray. Errors: some are missing, or of both forms; key: "header".
Result<bool> is_reduced_form(const std::array<bool, kRayColumns>& there);

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
Result<RayQuery> ray_query(const RayFields& fields, bool reduced, const Spacetime& spacetime);

}  // namespace nullscope::cli
