// Observers that move along the radius: their frame, and what light seen in it has of energy and of radial motion.
//
// Energy eps per rest mass, inward proper velocity w = sqrt(eps^2 - A). In ingoing coordinates v = t + r_*, regular at the horizon,
//     e_0 = d_v / outward - w d_r,   e_1 = d_v / outward + eps d_r,   outward = eps + w,  inward = eps - w = A / outward:
// the frequency at infinity of light that is seen with frequency 1 in the direction n is
//     E = (outward (1 + n_r) + inward (1 - n_r)) / 2 = eps + w n_r,
// so that outward and inward are E of light seen straight outward and straight inward. Along the traced ray dr goes as
//     (outward (1 + n_r) - inward (1 - n_r)) / 2 = w + eps n_r.
// At the horizon inward = 0, inside it is negative; nothing else happens there.
#pragma once
#include <cmath>

namespace nullscope {

struct RadialFrame {
    double outward = 1, inward = 1;
    double energy() const { return 0.5 * (outward + inward); }
    double infall() const { return 0.5 * (outward - inward); }
    friend bool operator==(const RadialFrame&, const RadialFrame&) = default;
};

// lapse2: A > 0.
inline RadialFrame frame_at_rest(double lapse2) { return {std::sqrt(lapse2), std::sqrt(lapse2)}; }
// energy^2 >= lapse2; outside the horizon energy > 0.
inline RadialFrame falling_frame(double lapse2, double energy) {
    const double outward = energy + std::sqrt(std::fmax(energy * energy - lapse2, 0.0));
    return {outward, lapse2 / outward};
}

}  // namespace nullscope
