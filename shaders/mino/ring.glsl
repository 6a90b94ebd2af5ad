// Rays next to the critical curve of a rotating hole, in views so narrow that float's digits and the errors of steps would show.
//
// Radial motion in Mino's time (mino/kerr.glsl) has the first integral
//     zeta'^2 = P(zeta) = E^2 + (a^2 E^2 - J^2) zeta^2 + K zeta^3 - (a^2 Q + c K) zeta^4,
// whose least value between the hole and the sky, the peak of the barrier, is at the saddle zeta_s. With w = zeta - zeta_s
//     P = peak + w^2 (steep + w (tilt - (a^2 Q + c K) w)).
// Next to the critical curve the peak is small. Every error of a step is an error of it, and grows exponentially. So states beside the saddle
// are put back on zeta'^2 = P; the peak of a narrow view comes from the host (observer/spin_ring.h); and zeta has more digits there: the sum
// of all steps is zeta + fine.
#include "shared/frame.glsl"

#define RING_BESIDE 0.5   // of the saddle's zeta: how far about it

struct RingBarrier {
    float saddle;
    float beside;     // 0: there is none outside of the horizon, or its peak is not known
    float steep;
    float tilt;
    float quartic;
    float peak;
};

// pixel: px from the picture's middle, y up; cubic in both.
float ring_peak(vec2 pixel) {
    float x = pixel.x;
    float y = pixel.y;
    vec4 a = frame.ring_peak;
    vec4 b = frame.ring_peak_2;
    vec4 c = frame.ring_peak_3;
    return a.x + x * (a.y + x * (a.w + x * b.z + y * b.w) + y * (b.x + y * c.x)) + y * (a.z + y * (b.y + y * c.y));
}

// fall = J^2 - a^2 E^2, k and quartic = a^2 Q + c K: the ray's. horizon: the outer one's radius. Without the host's peak, in views that are not small beside the
// hole, there is none: one formed here has fewer digits than the force itself.
RingBarrier ring_barrier(vec2 pixel, float fall, float k, float quartic, float horizon) {
    RingBarrier barrier;
    float root2 = 2.25 * k * k - 8.0 * quartic * fall;
    float root = sqrt(max(root2, 0.0));
    float saddle = 2.0 * fall / max(1.5 * k + root, 1.0e-30);
    barrier.saddle = saddle;
    barrier.beside = frame.ring_peak_3.z > 0.0 && root2 > 0.0 && saddle > 0.0 && saddle * horizon < 1.0 ? RING_BESIDE * saddle : 0.0;
    barrier.steep = saddle * root;
    barrier.tilt = k - 4.0 * quartic * saddle;
    barrier.quartic = quartic;
    barrier.peak = ring_peak(pixel);
    return barrier;
}

// w
float ring_offset(RingBarrier barrier, float zeta, float fine) { return zeta - barrier.saddle + fine; }

// zeta'' at w.
float ring_force(RingBarrier barrier, float w) { return w * (barrier.steep + w * (1.5 * barrier.tilt - 2.0 * barrier.quartic * w)); }

// What leads from w and zeta' to the nearest ones on zeta'^2 = P: one step of Newton's along the gradient.
vec2 ring_settling(RingBarrier barrier, float w, float slope) {
    float force = ring_force(barrier, w);
    float excess = slope * slope - (barrier.peak + w * w * (barrier.steep + w * (barrier.tilt - barrier.quartic * w)));
    float share = abs(w) < barrier.beside ? 0.5 * excess / max(barrier.steep * slope * slope + force * force, 1.0e-36) : 0.0;
    return vec2(share * force, -share * barrier.steep * slope);
}
