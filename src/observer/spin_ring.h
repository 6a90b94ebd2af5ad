// How far rays about a rotating hole are from the critical curve, to all digits, in views that are small beside the hole.
//
// Radial motion in Mino's time, zeta = 1/r (shaders/mino/kerr.glsl): zeta'^2 = P(zeta), whose least value between the hole and the sky,
// the peak, is 0 on the critical curve, positive inside of it and negative outside. The peak decides what a ray next to the curve does,
// and rounding of the ray's constants in float, 1e-7, moves it by as much as a microradian. So it is formed here in double, as a cubic of
// the pixel's place. spacetime: one that rotates.
#pragma once
#include <array>
#include <optional>

#include "observer/observer.h"
#include "observer/spin_forms.h"
#include "scene/scene.h"
#include "spacetime/axial_metric.h"

namespace nullscope {

// The peak over P'' zeta^2/2 at its place, "e": some two thirds of the relative distance from the curve. How it changes in a pixel's step at
// the picture's middle, at most.
double ring_distance_per_pixel(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer,
                               const LightSpec& light);

// Of single rays of one observer.
class RingOfRays {
public:
    // camera: its place alone.
    RingOfRays(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer);
    struct Barrier {
        double peak, height;
        double distance() const { return peak / height; }  // e
    };
    Barrier of(Vec3 n) const;  // unit, in the observer's own frame

private:
    SpinPlace place_;
    SpinForms forms_;
    double charge2_;
};

// May the picture show the critical curve, with pixels of less than kNarrow of it?
inline constexpr double kNarrow = 5e-4;
bool is_next_to_ring(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer,
                     const LightSpec& light);

// What is promised of rays in such a view: errors across the curve, px, and along it, rad of where their light ends. Beyond the spin kRingFastest
// and nearer to the horizon than kRingNearest, r_s, light winds so long that no more than kRingHardest_px is promised, and nothing along the curve.
inline constexpr double kRingFastest = 0.999, kRingNearest = 0.1;
inline constexpr double kRingAcross_px = 0.05, kRingAlong = 2e-3, kRingHardest_px = 0.5;
bool is_hard_ring(const Spacetime& spacetime, double camera_r);

struct PeakForm {
    // Of x^i y^j, px from the picture's middle, y up: 1, x, y, x^2, xy, y^2, x^3, x^2 y, x y^2, y^3. Per squared unit of frequency in the
    // observer's own frame.
    std::array<double, 10> c;
};

// Nothing where a cubic is off by more than kPeakOff_px of the picture, which is then not small beside the hole: there float has digits
// enough. 10 microseconds.
inline constexpr double kPeakOff_px = 5e-4;
std::optional<PeakForm> peak_form(const AxialMetric& metric, const CameraSpec& camera, const Observer& observer,
                                  const LightSpec& light);

}  // namespace nullscope
