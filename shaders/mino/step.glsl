// The steps of a ray about a rotating hole (mino/kerr.glsl): how long, one of them, and the last one to the sky.
#include "mino/kerr.glsl"

// A ray that winds for long is one whose end moves fast with its direction: its errors weigh less, and its steps may grow.
#ifndef METHOD_MINO
#define SPIN_STEP 0.6          // of a step, times the fastest rate at work there: twice the error at 0.7, half at 0.55
#ifdef EFFECT_SPIN_RING
#define SPIN_MOST_STEPS 512   // next to the ring of fast holes, whose light winds up to 35 times until it is 1e-8 closer
#define SPIN_GROWTH 0.0
#else
#define SPIN_MOST_STEPS 64
#define SPIN_GROWTH 0.07
#endif
#define SPIN_GROW_AFTER 20
#else                          // SPIN_STEP and SPIN_MOST_STEPS by the method; all steps of a ray in the same proportion
#include "generated/method"
#define SPIN_SHARE (SPIN_STEP / 0.6)
#define SPIN_GROW_AFTER int(20.0 / SPIN_SHARE + 0.5)
#define SPIN_GROWTH (0.07 * SPIN_SHARE)
#endif

#ifdef NEEDS_FINE_ZETA
// What is lost of a sum zeta + more.
float spin_fine(SpinState from, float more, float to) { return from.fine + (more - (to - from.y.w)); }

// The place after a step or a part of it.
vec4 spin_moved(SpinState from, vec4 more) {
    vec4 to = from.y + more;
    to.w = rounded_sum(from.y.w, more.w);
    return to;
}
#else
float spin_fine(SpinState from, float more, float to) { return 0.0; }
vec4 spin_moved(SpinState from, vec4 more) { return from.y + more; }
#endif

#ifdef EFFECT_SPIN_RING
// From a state that comes towards the saddle to one that leaves it.
bool ring_leaves(SpinRay ray, SpinState from, SpinState to) {
    float before = ring_offset(ray.barrier, from.y.w, from.fine) * from.v.w;
    float after = ring_offset(ray.barrier, to.y.w, to.fine) * to.v.w;
    return ray.barrier.beside > 0.0 && before < 0.0 && after >= 0.0;
}
#endif

#ifndef METHOD_MINO_4
// The places within a step where forces are asked for.
struct SpinStages {
    vec4 y1;
    vec4 y2;
    vec4 y3;
    vec4 y4;
    float fine1;
    float fine2;
    float fine3;
    float fine4;
};

// The mean over a step of what its start, its stages and its end have, by the weights of the speed.
float stages_mean(float from, float at1, float at2, float at3, float at4, float to) {
    return from * (151.0 / 2142.0) + at1 * (25.0 / 522.0) + at2 * (275.0 / 684.0) + at3 * (275.0 / 252.0) - at4 * (78125.0 / 112404.0) +
           to * (1.0 / 12.0);
}

#ifdef EFFECT_SPIN_RING
// Put back on the first integral, beside the saddle.
SpinState step_settled(SpinRay ray, SpinState to, float fine) {
    vec2 settling = ring_settling(ray.barrier, ring_offset(ray.barrier, to.y.w, fine), to.v.w);
    to.fine += settling.x;
    to.v.w += settling.y;
    return to;
}
#else
SpinState step_settled(SpinRay ray, SpinState to, float fine) { return to; }
#endif

#ifdef EFFECT_SPIN_FALL
SpinState step_inside(SpinRay ray, SpinState from, SpinState to, float fine) {
    to.ingoing = from.ingoing;
    // Rounding of a large zeta' deep inside is much, relative to what is left of it where rays wind: by the root while that is exact.
    float x = spin_x(ray, to.y.w, fine);
    float speed2 = ingoing_speed2(ray, to.y.w, fine, x);
    to.v.w = from.ingoing && to.v.w < 0.0 && speed2 > INGOING_SLOW * x * x ? -sqrt(speed2) : to.v.w;
    return to;
}

// Whose psi may belong to Boyer and Lindquist's azimuth from here on.
SpinState step_leaves(SpinRay ray, SpinState from, SpinState to, float fine) {
    to.ingoing = from.ingoing && ingoing_stays(ray, to);
    if (from.ingoing && !to.ingoing) {
        to.psi += spin_winding(ray, to.y.w, fine);
        to.drag = spin_drag(ray, to.y.w, fine);
    }
    return to;
}
#else
SpinState step_inside(SpinRay ray, SpinState from, SpinState to, float fine) { return to; }
SpinState step_leaves(SpinRay ray, SpinState from, SpinState to, float fine) { return to; }
#endif

#ifdef NEEDS_LIGHT_TIMES
SpinState step_timed(SpinRay ray, SpinState from, SpinStages at, SpinState to, float fine, float h) {
    bool keeps = travel_time_keeps(ray, from, to);
    to.afar = keeps ? from.afar : min(from.afar, AFAR_TURNED);
    to.travel_time = from.travel_time + travel_time_jump(ray, keeps, from.afar, vec3(from.y.w, from.v.w, spin_fine_of(from)), vec3(to.y.w, to.v.w, fine)) +
             h * stages_mean(travel_time_rate(ray, keeps, from.y, spin_fine_of(from)), travel_time_rate(ray, keeps, at.y1, at.fine1),
                             travel_time_rate(ray, keeps, at.y2, at.fine2), travel_time_rate(ray, keeps, at.y3, at.fine3),
                             travel_time_rate(ray, keeps, at.y4, at.fine4), travel_time_rate(ray, keeps, to.y, fine));
    return to;
}
#else
SpinState step_timed(SpinRay ray, SpinState from, SpinStages at, SpinState to, float fine, float h) { return to; }
#endif

#ifdef NEEDS_FINE_AZIMUTH
#define FINE_AZIMUTH_FROM 0.45   // of the horizon's 1/r: where a step ends beyond it, its own sum of psi' loses digits
#define FINE_AZIMUTH_FAST 0.5    // zeta'^2 over X^2, which is 1 at the horizon and 0 where a ray turns

#ifdef EFFECT_SPIN_NEAR
// Outward along the past horizon's light?
bool step_rises(SpinRay ray, SpinState from, SpinState to) {
    float near_x = spin_x(ray, from.y.w, from.fine);
    bool rises = from.v.w < 0.0 && to.v.w < 0.0 && ray.outer * from.y.w > FINE_AZIMUTH_FROM && from.v.w * from.v.w > FINE_AZIMUTH_FAST * near_x * near_x;
#ifdef EFFECT_SPIN_FALL
    rises = rises && !from.ingoing;
#endif
    return rises;
}

float near_turned(float psi) { return near_turn(psi); }
#else
bool step_rises(SpinRay ray, SpinState from, SpinState to) { return false; }
float near_turned(float psi) { return psi; }
#endif

// Along the horizon's light, which phi winds up with: what is left of it is regular there. Not of rays that turn, whose neighbours would be summed otherwise.
SpinState step_wound(SpinRay ray, SpinState from, SpinStages at, SpinState to, float fine, float h) {
    float fine_x = spin_x(ray, to.y.w, fine);
    bool rises = step_rises(ray, from, to);
    bool regular = (from.v.w > 0.0 && to.v.w > 0.0 && ray.outer * to.y.w > FINE_AZIMUTH_FROM && to.v.w * to.v.w > FINE_AZIMUTH_FAST * fine_x * fine_x) || rises;
    float wound = spin_wound(ray, from.y.w, spin_fine_of(from), to.y.w, fine);
    float turned = from.psi + (rises ? -wound : wound) +
                   h * stages_mean(spin_level_turning(ray, from.y.w, spin_fine_of(from)), spin_level_turning(ray, at.y1.w, at.fine1),
                                   spin_level_turning(ray, at.y2.w, at.fine2), spin_level_turning(ray, at.y3.w, at.fine3),
                                   spin_level_turning(ray, at.y4.w, at.fine4), spin_level_turning(ray, to.y.w, fine));
    to.psi = near_turned(regular ? turned : to.psi);
    return to;
}
#else
SpinState step_wound(SpinRay ray, SpinState from, SpinStages at, SpinState to, float fine, float h) { return to; }
#endif

#ifdef NEEDS_FINE_ZETA
SpinState step_fine(SpinState to, float fine) {
    to.fine = fine;
    return to;
}
#else
SpinState step_fine(SpinState to, float fine) { return to; }
#endif

// One step of RKN6(4)6FM (Dormand, El-Mikkawy and Prince 1987): five new forces, the sixth is the next step's first.
SpinState spin_step(SpinRay ray, SpinState from, float h) {
    float hh = h * h;
    vec4 v = h * from.v;
    vec4 f0 = hh * from.f;
    SpinStages at;
    vec4 more = 0.1 * v + f0 * (1.0 / 200.0);
    at.y1 = spin_moved(from, more);
    at.fine1 = spin_fine(from, more.w, at.y1.w);
    vec4 f1 = hh * spin_force(ray, at.y1, at.fine1);
    more = 0.3 * v - f0 * (1.0 / 2200.0) + f1 * (1.0 / 22.0);
    at.y2 = spin_moved(from, more);
    at.fine2 = spin_fine(from, more.w, at.y2.w);
    vec4 f2 = hh * spin_force(ray, at.y2, at.fine2);
    more = 0.7 * v + f0 * (637.0 / 6600.0) - f1 * (7.0 / 110.0) + f2 * (7.0 / 33.0);
    at.y3 = spin_moved(from, more);
    at.fine3 = spin_fine(from, more.w, at.y3.w);
    vec4 f3 = hh * spin_force(ray, at.y3, at.fine3);
    more = 0.68 * v + f0 * (225437.0 / 1968750.0) - f1 * (30073.0 / 281250.0) + f2 * (65569.0 / 281250.0) -
           f3 * (9367.0 / 984375.0);
    at.y4 = spin_moved(from, more);
    at.fine4 = spin_fine(from, more.w, at.y4.w);
    vec4 f4 = hh * spin_force(ray, at.y4, at.fine4);
    SpinState to;
    more = v + f0 * (151.0 / 2142.0) + f1 * (5.0 / 116.0) + f2 * (385.0 / 1368.0) + f3 * (55.0 / 168.0) -
           f4 * (6250.0 / 28101.0);
    to.y = spin_moved(from, more);
    float fine = spin_fine(from, more.w, to.y.w);
    to.f = spin_force(ray, to.y, fine);
    to.v = from.v + (f0 * (151.0 / 2142.0) + f1 * (25.0 / 522.0) + f2 * (275.0 / 684.0) + f3 * (275.0 / 252.0) -
                     f4 * (78125.0 / 112404.0) + (hh / 12.0) * to.f) / h;
    to = step_inside(ray, from, step_settled(ray, step_fine(to, fine), fine), fine);
    to.drag = spin_turning_at(ray, to);
    to = step_timed(ray, from, at, to, fine, h);
    to.psi = from.psi + h * stages_mean(from.drag, spin_turning(ray, from, at.y1.w, at.fine1), spin_turning(ray, from, at.y2.w, at.fine2),
                                        spin_turning(ray, from, at.y3.w, at.fine3), spin_turning(ray, from, at.y4.w, at.fine4), to.drag);
    return step_leaves(ray, from, step_wound(ray, from, at, to, fine, h), fine);
}
#endif

#ifdef EFFECT_SPIN_FALL
#ifdef EFFECT_DISC_LEAN
#define INGOING_OUT 0.985    // of the horizon's 1/r: a step from within ends here, so that none is half within and half on a disc that leans
bool fall_slows(SpinRay ray, SpinState at) { return !at.ingoing || at.y.w * ray.outer < 1.0; }
float ingoing_out(SpinRay ray, SpinState at, float h) {
    float way = at.y.w - INGOING_OUT / ray.outer;
    return at.ingoing && at.y.w * ray.outer >= 1.0 && at.v.w < 0.0 ? min(h, -way / at.v.w) : h;
}
#else
bool fall_slows(SpinRay ray, SpinState at) { return !at.ingoing; }
float ingoing_out(SpinRay ray, SpinState at, float h) { return h; }
#endif
#endif

// SPIN_STEP over the fastest rate: the sphere's, the radius' and how fast Delta changes next to the horizon (more on the way out, where
// the dragging is of use; on the way in a step must be able to pass the horizon). On its way out a ray ends its last step a little
// beyond the sky at zeta = 0.
float spin_step_length(SpinRay ray, SpinState at, int left) {
    float zeta = at.y.w;
    float slope = at.v.w;
    float delta = spin_delta(ray, zeta, spin_fine_of(at));
#ifdef EFFECT_SPIN_FALL
    float fall = fall_slows(ray, at) ? slope * (0.5 - ray.a2c * zeta) / delta : 0.0;
#else
    float fall = slope * (0.5 - ray.a2c * zeta) / delta;
#endif
    float rate2 = abs(ray.j2) + ray.a2e2 + 0.125 * ray.energy * ray.energy + 1.5 * ray.k * zeta + (slope < 0.0 ? 3.0 : 1.0 + 3.0 * min(2.0 * delta, 1.0)) * fall * fall;
#ifdef EFFECT_SPIN_FALL
    rate2 += INGOING_DEEP * ray.k * zeta * clamp(ray.outer * zeta - 1.0, 0.0, 1.0);   // inside, where zeta changes by its own size
#endif
#ifdef METHOD_MINO
    if (slope > 0.0 && SPIN_SHARE < 1.0) rate2 -= (1.0 - SPIN_SHARE * SPIN_SHARE) * fall * fall;   // short steps pass the horizon too
#endif
    float h = SPIN_STEP * (1.0 + SPIN_GROWTH * max(float(SPIN_MOST_STEPS - SPIN_GROW_AFTER - left), 0.0)) * inversesqrt(rate2);
#ifdef EFFECT_SPIN_FALL
    h = ingoing_out(ray, at, h);
#endif
    return slope < 0.0 ? min(h, -1.05 * zeta / slope) : h;
}

// Inside the horizon every ray is traced outward, and none whose energy is not above 0 has come from our sky. Of the others those whose photon has
// E (r_+^2 + a^2) <= a L have crossed another horizon than the one that the camera fell through: they meet nothing of ours.
#ifdef EFFECT_SPIN_FALL
bool starts_outside(SpinRay ray) { return frame.shift.y * ray.outer < 1.0; }
bool sees_ours(SpinRay ray, bool outside) { return outside || ray.a * ray.momentum > ray.energy * (ray.outer - frame.spin_turn.z); }
bool comes_outside(bool outside, float zeta, float end) { return outside || zeta < end; }
#else
bool starts_outside(SpinRay ray) { return true; }
bool sees_ours(SpinRay ray, bool outside) { return true; }
bool comes_outside(bool outside, float zeta, float end) { return true; }
#endif

// A ray ends at the sky, and at the horizon once it has been outside of it.
bool spin_goes(float zeta, float end, int left, bool outside) { return zeta > 0.0 && (zeta < end || !outside) && left > 0; }

// What is left to zeta = 0 after the step that passed it: zeta is nearly a harmonic oscillator there. The time by three terms of its
// arctangent, one step back by that, and the rest by the second order.
SpinState spin_to_sky(SpinRay ray, SpinState beyond) {
    float x = beyond.y.w / min(beyond.v.w, -1.0e-20);
    float w = (ray.j2 - ray.a2e2) * x * x;
    SpinState at = spin_step(ray, beyond, -x * (1.0 - w * (1.0 / 3.0 - 0.2 * w)) - 1.0e-20);
    float rest = -at.y.w / min(at.v.w, -1.0e-20);
    at.y += rest * (at.v + 0.5 * rest * at.f);
    at.psi += rest * at.drag;
#ifdef NEEDS_LIGHT_TIMES
    at.travel_time += rest * travel_time_rate(ray, true, at.y, spin_fine_of(at));
#endif
    return at;
}

// A step that may have met something.
struct SpinStep {
    SpinState from;
    SpinState to;
    float h;
    float begun;      // Mino's time where it begins
    bool crosses;     // the disc's plane
    bool near;        // the band that bodies keep to
};

// None yet.
SpinStep step_from(SpinState start) {
    SpinStep none;
    none.from = start;
    none.to = start;
    none.h = 1.0;
    none.begun = 0.0;
    none.crosses = false;
    none.near = false;
    return none;
}
