// Parallel transport of a camera's screen axes along a ray, by integration in Cartesian coordinates: no constant of the motion is used, neither
// Walker and Penrose's of a vector nor any of the ray. Every metric with discs is g = eta + F l l in coordinates where matter falls in regularly,
// l null, t = v - r: about rotating holes Kerr and Schild's (kerr_chart.h), elsewhere F = 1 - A and l = (1, x/r).
#pragma once
#include <array>
#include <memory>
#include <optional>

#include "reference/kerr_chart.h"
#include "reference/traced_ray.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::reference {

using FourVector = std::array<double, 4>;  // t, x, y, z

// F and l at a place, and their derivatives by x, y, z.
struct NullForm {
    double f;
    FourVector l;  // covariant, l_t = 1
    std::array<double, 3> df;
    std::array<FourVector, 3> dl;
};

class CarryingMetric {
public:
    virtual ~CarryingMetric() = default;
    virtual NullForm at(const Vec3& x) const = 0;
    virtual double radius(const Vec3& x) const = 0;  // Boyer and Lindquist's, r_s
    virtual double a() const { return 0; }           // of a rotating hole, r_s
    double product(const Vec3& x, const FourVector& u, const FourVector& v) const;
};

// Null: a metric without a disc.
std::unique_ptr<const CarryingMetric> carrying_metric(const Spacetime& spacetime);

// Where a ray meets the equatorial plane: the photon's momentum of unit frequency in the camera, and the camera's right and up in its direction's
// plane (observer/screen_form.h), carried there; contravariant.
struct CarriedAxes {
    Vec3 place;
    FourVector k, right, up;
};

// A ray from the camera, step by step. tetrad: the camera's e_0, right, up, backward in ingoing coordinates (v, r, theta, phi~/sin(theta)).
// direction: where the photon comes from, along right, up and backward, unit.
class CarriedRay {
public:
    CarriedRay(const CarryingMetric& metric, const CameraSpec& camera, const Tetrad& tetrad, Vec3 direction);
    // A step of at most `length` r_s in these coordinates, as long as its error allows. False: next to a horizon none is of use, and nothing has moved.
    bool advance(double length);
    CarriedAxes now() const;
    double affine() const { return state_[15]; }  // from the camera, of a photon of unit frequency there, r_s

    using State = std::array<double, 16>;  // x, y, z; k; right; up; affine parameter
    const State& state() const { return state_; }
    double taken() const { return taken_; }  // the last step, of the parameter that it integrates by

private:
    const CarryingMetric& metric_;
    State state_;
    double step_, taken_ = 0;
};

// crossing: 1 for the first. Nothing: the ray has left before, or fell in. Some milliseconds; within 1e-11.
std::optional<CarriedAxes> carried_axes(const CarryingMetric& metric, const CameraSpec& camera, const Tetrad& tetrad,
                                        Vec3 direction, int crossing);

}  // namespace nullscope::reference
