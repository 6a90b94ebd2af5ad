// Rays as curves in files: CSV, a line a point, and OBJ, a polyline a ray.
#pragma once
#include <span>
#include <string>

#include "command/ray_curves.h"

namespace nullscope::cli {

struct CurveForm {
    bool cartesian = false;  // x, y, z in the place of r, theta, phi
    bool rates = false;      // derivatives by the affine parameter too
};
// Columns ray (the row's number, from 1), lambda, r, theta, phi, t [, r_rate, theta_rate, phi_rate, t_rate].
std::string curves_csv(std::span<const Curve> curves, const CurveForm& form);
std::string curves_obj(std::span<const Curve> curves);  // z is the polar axis

}  // namespace nullscope::cli
