// One pixel's ray about a rotating hole, from the camera to its end (mino/kerr.glsl). In place of planar/trace.glsl, where rays stay in planes:
// the same Trace as far as a sky asks for it. Reads the global `frame` (FrameData).
//
// Inside the horizon every ray is traced outward, and none whose energy is not above 0 has come from our sky. Of the others those with
// E (r_+^2 + a^2) <= a L have crossed another horizon than the one that the camera fell through: they meet nothing of ours.
#ifdef EFFECT_ABERRATION
#include "core/aberration.glsl"
#endif
#ifdef EFFECT_DISC
#include "mino/leg.glsl"
#endif
#include "mino/ray.glsl"
#include "mino/step.glsl"
#ifdef METHOD_KERR_SCHILD
#include "generated/method"
#endif
#ifdef NEEDS_PLACE
#include "mino/march.glsl"
#endif
#include "shared/frame.glsl"

#define SPIN_CROSSINGS 4   // of the disc that are kept: layers of a translucent one
#define SPIN_RIM 0.125     // of the disc's width, and of its inner radius: by no more is it widened for rims that cover a pixel in part

#define SPIN_FARTHEST 1.0e10   // a crossing beyond it lies behind the sky

struct Trace {
    float doppler;        // frequency in the camera over that in the observer's frame
    float pixel_angle;    // angle that one pixel spans here, rad, in the observer's frame
    bool escapes;
    bool lost;            // neither here nor there after SPIN_MOST_STEPS
    vec3 sky;             // direction on the celestial sphere, world axes, unit to rounding; of use if escapes
    float stretch_along;  // how fast the sky direction moves: of the footprint's sides the longer ...
    float stretch_across; // ... and the area over it
#ifdef NEEDS_FOOTPRINT
    vec3 sky_right;       // and the same to the right and upward
    vec3 sky_up;
#endif
    int steps;
#ifdef EFFECT_DELAY
    float lag;            // T, of a ray that escapes
#endif
    float momentum;       // of the photon over its frequency in the observer's frame
    float energy;
#ifdef EFFECT_DISC
    int crossings;        // of the disc, or close to its rims: how many of these there are
    SpinCrossing crossing_0;
    SpinCrossing crossing_1;
    SpinCrossing crossing_2;
    SpinCrossing crossing_3;
#endif
#ifdef NEEDS_PLACE
    SolidHit solid;       // the first body
#ifdef NEEDS_FOOTPRINT
    vec3 solid_right;     // how it moves from pixel to pixel
    vec3 solid_up;
#endif
#endif
};

#ifdef NEEDS_PLACE
SolidHit solid_hit(Trace trace, float blur) { return trace.solid; }
#endif

// What every kind of path says of its rays (planar/trace.glsl).
float path_spin() { return frame.spin_hole.x; }
float path_steps(Trace trace) { return float(trace.steps); }
float swept_angle(float along) { return 0.0; }   // Mino's time is none
float path_angle(Trace trace) { return 0.0; }

// g: the camera's frequency over that at infinity.
float g_of(Trace trace) { return trace.doppler / max(trace.energy, 1.0e-6); }

// A ray ends at the sky, and at the horizon once it has been outside of it.
bool spin_goes(float zeta, float end, int left, bool outside) { return zeta > 0.0 && (zeta < end || !outside) && left > 0; }

// pixel: px from the image centre, x to the right, y up.
Trace trace_pixel(vec2 pixel) {
    Trace trace;
    float inverse_length = inversesqrt(1.0 + dot(pixel, pixel) * (frame.image.z * frame.image.z));
    vec4 look = (frame.ray_0 + pixel.x * frame.ray_x + pixel.y * frame.ray_y) * inverse_length;
    vec3 n = vec3(look.x, look.y, look.z);
    trace.pixel_angle = frame.image.z * inverse_length * sqrt(inverse_length);
    float doppler = 1.0;
#ifdef EFFECT_ABERRATION
    Aberration seen = aberrate(n, vec3(frame.boost.x, frame.boost.y, frame.boost.z), frame.boost.w, frame.boost_colour.x);
    n = seen.direction;
    doppler = seen.doppler;
    trace.pixel_angle *= seen.squeeze;
#endif
    SpinRay ray = spin_ray(n);
    trace.energy = -ray.energy;
    trace.momentum = -ray.momentum;
    trace.doppler = doppler;
#ifdef METHOD_KERR_SCHILD
    vec4 marched = kerr_schild_march(ray, n);
    trace.steps = int(abs(marched.w));
    trace.escapes = marched.w > 0.0;
    trace.lost = false;
    trace.sky = trace.escapes ? vec3(marched.x, marched.y, marched.z) : -n;
#else
    SpinState now = spin_start(ray, n);
    float end = 1.0 / ray.outer;
    int left = SPIN_MOST_STEPS;
    bool going = true;
#ifdef EFFECT_SPIN_FALL
    bool outside = frame.shift.y * ray.outer < 1.0;
    bool ours = outside || ray.a * ray.momentum > ray.energy * (ray.outer - frame.spin_turn.z);   // of the photon: E (r_+^2 + a^2) > a L
#else
    bool outside = true;
#endif
    float tau = 0.0;
#ifdef NEEDS_PLACE
    SolidSearch search = solid_search();
#ifdef EFFECT_SPIN_FALL
    search.going = ours;
#endif
#ifdef NEEDS_FOOTPRINT
    float blur = 1.0;
#else
    float blur = 0.0;
#endif
#endif
#ifdef EFFECT_DISC
    trace.crossings = 0;
    SpinCrossing none;
    none.number = 0.0;
    none.along = 0.0;
    none.r = 0.0;
    none.place = vec2(0.0, 0.0);
    none.climb = 0.0;
#ifdef EFFECT_DELAY
    none.late = 0.0;
#endif
    trace.crossing_0 = none;
    trace.crossing_1 = none;
    trace.crossing_2 = none;
    trace.crossing_3 = none;
    SpinState from = now;
    SpinState to = now;
    float taken = 1.0;
    float begun = 0.0;
    float number = 0.0;
    float rim = SPIN_RIM * min(frame.disc_y.w - frame.disc_x.w, frame.disc_x.w);
    do {   // from one crossing of the plane to the next; loops are tested at the end, see disc_cover.glsl
        bool crossed = false;
        do {
            SpinState before = now;
            float h = spin_step_length(ray, now, left);
            now = spin_step(ray, now, h);
            --left;
#ifdef NEEDS_PLACE
            search = step_search(ray, before, now, h, tau, trace.pixel_angle, blur, search);
            now.psi = search.psi;
#endif
            // What is used after the loop is kept in a branch: Mesa 22's software driver gives a ray that has left a loop what later rounds
            // of the others make of variables that no round takes over from the one before.
            if (before.y.z * now.y.z < 0.0 || (now.y.z == 0.0 && before.y.z != 0.0)) {
                from = before;
                to = now;
                taken = h;
                begun = tau;
                crossed = true;
            }
            tau += h;
#ifdef EFFECT_SPIN_FALL
            outside = outside || now.y.w < end;
#endif
            going = spin_goes(now.y.w, end, left, outside);
        } while (going && !crossed);
        going = spin_goes(now.y.w, end, left, outside);
        SpinCrossing crossing = spin_crossing(ray, from, to, taken, begun);
#ifdef EFFECT_SPIN_FALL
        crossed = crossed && ours;
#endif
        number += crossed ? 1.0 : 0.0;
        crossing.number = number;
        if (crossed && number > frame.disc_look.w && crossing.r > max(ray.outer, frame.disc_x.w - rim) && crossing.r < min(SPIN_FARTHEST, frame.disc_y.w + rim)) {
            if (trace.crossings == 0) trace.crossing_0 = crossing;
            if (trace.crossings == 1) trace.crossing_1 = crossing;
            if (trace.crossings == 2) trace.crossing_2 = crossing;
            if (trace.crossings == 3) trace.crossing_3 = crossing;
            ++trace.crossings;
        }
    } while (going);
#else
    do {
#ifdef NEEDS_PLACE
        SpinState before = now;
        float h = spin_step_length(ray, before, left);
        now = spin_step(ray, before, h);
        search = step_search(ray, before, now, h, tau, trace.pixel_angle, blur, search);
        now.psi = search.psi;
        tau += h;
#else
        now = spin_step(ray, now, spin_step_length(ray, now, left));
#endif
        --left;
#ifdef EFFECT_SPIN_FALL
        outside = outside || now.y.w < end;
#endif
        going = spin_goes(now.y.w, end, left, outside);
    } while (going);
#endif
#ifdef NEEDS_PLACE
    trace.solid = solid_found(search);
#endif
    trace.steps = SPIN_MOST_STEPS - left;
    trace.escapes = now.y.w <= 0.0 && trace.energy > 0.0;
    trace.lost = now.y.w > 0.0 && now.y.w < end;
    SpinState sky = spin_to_sky(ray, now);
#ifdef EFFECT_DELAY
    trace.lag = sky.lag;
#endif
    float c = cos(sky.psi);
    float s = sin(sky.psi);
    trace.sky = trace.escapes ? vec3(c * sky.y.x - s * sky.y.y, s * sky.y.x + c * sky.y.y, sky.y.z) : -n;
#endif
#ifdef NEEDS_FOOTPRINT
    vec3 right = dFdx(trace.sky);
    vec3 up = dFdy(trace.sky);
    trace.sky_right = right;
    trace.sky_up = up;
    float longer = max(sqrt(max(dot(right, right), dot(up, up))), 1.0e-20);
    vec3 area = cross(right, up);
    trace.stretch_along = longer / trace.pixel_angle;
    trace.stretch_across = sqrt(dot(area, area)) / (longer * trace.pixel_angle);
#ifdef NEEDS_PLACE
    trace.solid_right = dFdx(trace.solid.place.at);
    trace.solid_up = dFdy(trace.solid.place.at);
    float met = float(trace.solid.object);
    float side = trace.pixel_angle * search.length;
    if (abs(dFdx(met)) + abs(dFdy(met)) > 0.0) {   // straight light, across it
        vec3 ahead = normalize(trace.solid.place.velocity);
        trace.solid_right = side * normalize(cross(ahead, abs(ahead.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
        trace.solid_up = cross(trace.solid_right, ahead);
    }
#endif
#else
    trace.stretch_along = 1.0;
    trace.stretch_across = 1.0;
#endif
    return trace;
}

#ifdef EFFECT_SKY_PATTERN
// Sides of the pixel's box on the sky, to the right and upward.
struct SkySides {
    vec3 along;
    vec3 across;
};
SkySides sky_sides(Trace trace) {
    SkySides sides;
    sides.along = trace.sky_right;
    sides.across = trace.sky_up;
    return sides;
}
#endif

#ifdef NEEDS_PLACE
#ifdef NEEDS_FOOTPRINT
// How the place of the body that is met moves with the pixel, to the right and upward.
struct SolidSides {
    vec3 within;
    vec3 round;
};
SolidSides solid_sides(Trace trace, RayPlace place) {
    SolidSides sides;
    sides.within = trace.solid_right;
    sides.round = trace.solid_up;
    return sides;
}
#endif
#endif
