// A ray as a curve: points along it, of every metric, for drawings, models and checks of constants of motion.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "reference/frame_tracer.h"
#include "reference/metric.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::reference {

// The metric's own coordinates, about rotating holes Boyer and Lindquist's; r in r_s, in wormholes l. The affine parameter grows away from the
// camera and is that of a photon of unit energy at infinity, r_s: dt/d(affine) = -1 far out. t is the time, r_s/c. Both are 0 at the first point.
// The rates are derivatives by the affine parameter. t and its rate: NaN of rays that begin inside a horizon.
struct CurvePoint {
    double affine = kNotANumber, r = kNotANumber, theta = kNotANumber, phi = kNotANumber, t = kNotANumber;
    double r_rate = kNotANumber, theta_rate = kNotANumber, phi_rate = kNotANumber, t_rate = kNotANumber;
};

struct CurveSpec {
    int points;             // 2 or more
    double farthest = 100;  // r_s: what is farther from the centre is left out, at both ends
    // Where curves end, if they come there: at this r, r_s, or l; this polar angle, rad; this of Mino's time after the first point, 1/r_s
    // (d(affine) = Sigma d(Mino)). To some roundings.
    std::optional<double> to_r{}, to_theta{}, to_mino{};
};

// The scene's metric, opaque disc and bodies, which end rays.
class CurveTracer {
public:
    static Result<CurveTracer> make(const Scene& scene);  // errors: as trace_ray's
    CurveTracer(CurveTracer&&) noexcept;
    ~CurveTracer();
    // From the camera to the hit, to 1.01 of the horizon's radius, or to where the ray leaves the sphere of radius `farthest`. Even in the root of
    // d(affine)^2/(R^2 + r_s^2) + d(angle)^2, R the areal radius, the angle that about the centre: a step is a fixed part of the distance to the hole
    // far off, and a fixed angle where the ray winds. Empty: the ray does not come within `farthest`, ends nowhere, or has no positive energy.
    // Constants of motion of its points hold to 1e-9 (tests/cli/test_trace_curves.py). About 5 us a point about a
    // rotating hole; where places are found by search (janis-newman-winicour) 5 ms.
    Result<std::vector<CurvePoint>> curve(const RayQuery& query, const CurveSpec& spec) const;

private:
    CurveTracer() = default;
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};

// Of a camera's ray that stays in no plane, by what its tracer says of it.
struct PixelOnCurve {
    double x, y, camera_r;  // px; r_s
    double g;               // of the traced ray
    double end;             // along, of what ends it; infinite: nothing
};
// Empty as CurveTracer::curve, and for rays in planes. spacetime: of the tracer's scene.
std::vector<CurvePoint> pixel_curve(const FrameTracer& tracer, const Spacetime& spacetime, const PixelOnCurve& pixel,
                                    const CurveSpec& spec);

}  // namespace nullscope::reference
