// One pixel's ray about a rotating hole, from the camera to its end (mino/kerr.glsl). In place of planar/trace.glsl, where rays stay in planes:
// the same Trace as far as a sky asks for it. Reads the global `frame` (FrameData).
//
// Inside the horizon every ray is traced outward, and none whose energy is not above 0 has come from our sky. Of the others those with
// E (r_+^2 + a^2) <= a L have crossed another horizon than the one that the camera fell through: they meet nothing of ours.
#include "core/trig.glsl"
#ifdef NEEDS_FOOTPRINT
#include "core/pixel_sides.glsl"
#include "effect/sampling.glsl"
#endif
#ifdef EFFECT_DISC
#include "mino/segment.glsl"
#include "object/disc_rim.glsl"
#endif
#include "mino/ray.glsl"
#ifdef EFFECT_REFINE
#include "mino/ray_way.glsl"
#endif
#include "mino/step.glsl"
#ifdef METHOD_KERR_SCHILD
#include "generated/method"
#endif
#ifdef NEEDS_PLACE
#include "mino/march.glsl"
#endif
#include "shared/frame.glsl"

#define SPIN_CROSSINGS 4   // of the disc that are kept: layers of a translucent one
#define SPIN_FARTHEST 1.0e10   // a crossing beyond it lies behind the sky

#ifdef EFFECT_DISC
#define TRACE_STOPS   // at steps that meet something, which is then looked at once for all of the driver's rays
#endif
#ifdef NEEDS_PLACE
#define TRACE_STOPS
#endif
struct Trace {
    float doppler;        // frequency in the camera over that in the observer's frame
    float pixel_angle;    // angle that one pixel spans here, rad, in the observer's frame
    bool escapes;
    vec3 sky;             // direction on the celestial sphere, world axes, unit to rounding; of use if escapes
    float stretch_along;  // how fast the sky direction moves: of the footprint's sides the longer ...
    float stretch_across; // ... and the area over it
#ifdef NEEDS_FOOTPRINT
    PixelSides sky_sides; // and the same to the right and upward
#endif
    int steps;
#ifdef NEEDS_LIGHT_TIMES
    float travel_time;            // T, of a ray that escapes
#endif
    float momentum;       // of the photon over its frequency in the observer's frame
    float energy;
#ifdef EFFECT_REFINE
    float way;            // spin_way
#endif
#ifdef EFFECT_DISC
    int crossings;        // of the disc, or close to its rims: how many of these there are
    DiscCrossing crossing_0;
    DiscCrossing crossing_1;
    DiscCrossing crossing_2;
    DiscCrossing crossing_3;
#endif
#ifdef NEEDS_PLACE
    SolidHit solid;       // the first body
#ifdef NEEDS_FOOTPRINT
    PixelSides solid_sides;   // how it moves from pixel to pixel, to the right and upward
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
#ifdef EFFECT_ZOOM
float ring_part(float phi, float all) { return 0.0; }   // trace_pixel() counts it
#endif
#ifdef EFFECT_REFINE
float path_way(Trace trace) { return trace.way; }
#endif

// g: the camera's frequency over that at infinity.
float g_of(Trace trace) { return trace.doppler / max(trace.energy, 1.0e-6); }

#ifdef EFFECT_DISC
bool within_disc(float r) { return r >= frame.disc_x.w && r <= frame.disc_y.w; }
bool spin_disc_more(Trace trace, int k) { return k < min(trace.crossings, SPIN_CROSSINGS); }

#ifdef NEEDS_FOOTPRINT
// Crossing k with its footprint. Where a neighbour has none of this number: as if the disc were looked at from here,
// straight.
DiscCrossing spin_footprint(Trace trace, int k, DiscCrossing crossing) {
    float there = spin_disc_more(trace, k) ? crossing.number : 0.0;
    float edge = abs(dFdx(there)) + abs(dFdy(there));
    float side = trace.pixel_angle * (crossing.r + 1.0 / frame.shift.y);
    vec2 along = dFdx(crossing.place) * sampling_share();
    vec2 across = dFdy(crossing.place) * sampling_share();
    crossing.along = edge == 0.0 ? along : vec2(side, 0.0);
    crossing.across = edge == 0.0 ? across : vec2(0.0, side);
    return crossing;
}
#endif
#endif

Trace trace_pixel(vec2 pixel) {
    Trace trace;
    SpinView view = spin_view(pixel);
    vec3 n = view.direction;
    trace.pixel_angle = view.pixel_angle;
    SpinRay ray = spin_ray(view);
    trace.energy = -ray.energy;
    trace.momentum = -ray.momentum;
    trace.doppler = view.doppler;
#ifdef METHOD_KERR_SCHILD
    vec4 marched = kerr_schild_march(ray, n);
    trace.steps = int(abs(marched.w));
    trace.escapes = marched.w > 0.0;
    trace.sky = trace.escapes ? vec3(marched.x, marched.y, marched.z) : -n;
#ifdef EFFECT_REFINE
    trace.way = spin_way(trace.escapes, 0.0, 0.0);
#endif
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
    DiscCrossing none = no_crossing();
    trace.crossing_0 = none;
    trace.crossing_1 = none;
    trace.crossing_2 = none;
    trace.crossing_3 = none;
    float number = 0.0;
#ifdef EFFECT_REFINE
    float within = 0.0;   // crossings inside of the inner rim, beyond the outer rim
    float beyond = 0.0;
    bool covered = false; // by an opaque disc
#endif
#ifdef EVERY_CROSSING
    float rim = SPIN_FARTHEST;
#else
    float rim = disc_rim();
#endif
#endif
    bool crossed = false;   // the disc's plane
    bool near = false;      // the band that bodies keep to
#ifdef TRACE_STOPS
    SpinState from = now;
    SpinState to = now;
    float taken = 1.0;
    float begun = 0.0;
    do {   // from one step that meets something to the next; loops are tested at the end, see disc_cover.glsl
        crossed = false;
#ifdef NEEDS_PLACE
        do {   // and from one that may to the next
#endif
        near = false;
#endif
        do {
            SpinState before = now;
            float h = spin_step_length(ray, before, left);
            now = spin_step(ray, before, h);
#ifdef EFFECT_ZOOM
            // Half of its way: from here on all that the picture leaves out is behind the ray.
            if (ring_leaves(ray, before, now)) {
                now.psi += frame.ring.x;
#ifdef EFFECT_DISC
                number += frame.ring.z;
#endif
#ifdef NEEDS_LIGHT_TIMES
                now.travel_time += frame.ring.y;
#endif
            }
#endif
            --left;
#ifdef TRACE_STOPS
            bool crosses = false;
            bool meets = false;
#ifdef EFFECT_DISC
            crosses = before.y.z * now.y.z < 0.0 || (now.y.z == 0.0 && before.y.z != 0.0);
#endif
#ifdef NEEDS_PLACE
            if (segment_reaches(before, now, h)) {
                meets = search.going && step_meets(before, now, h);
                if (!meets) search.length = length_behind(search, before, now);
            }
#endif
            // What is used after the loop is kept in a branch: Mesa 22's software driver gives a ray that has left a loop what later rounds
            // of the others make of variables that no round takes over from the one before.
            if (crosses || meets) {
                from = before;
                to = now;
                taken = h;
                begun = tau;
                crossed = crosses;
                near = meets;
            }
#endif
            tau += h;
#ifdef EFFECT_SPIN_FALL
            outside = outside || now.y.w < end;
#endif
            going = spin_goes(now.y.w, end, left, outside);
        } while (going && !crossed && !near);
#ifdef TRACE_STOPS
        going = spin_goes(now.y.w, end, left, outside);
#endif
#ifdef NEEDS_PLACE
            if (near && !step_touches(ray, from, to, taken)) {
                near = false;
                search.length = length_behind(search, from, to);
            }
        } while (going && !crossed && !near);
        if (near) {
            search = step_search(ray, from, to, taken, begun, trace.pixel_angle, blur, search);
            now.psi = search.psi;
        }
#endif
#ifdef EFFECT_DISC
        DiscCrossing crossing = spin_crossing(ray, from, to, taken, begun);
#ifdef EFFECT_SPIN_FALL
        crossed = crossed && ours;
#endif
        number += crossed ? 1.0 : 0.0;
        crossing.number = number;
#ifdef EFFECT_REFINE
        bool counts = crossed && !covered && number > frame.disc_surface.w;
        within += counts && crossing.r < frame.disc_x.w ? 1.0 : 0.0;
        beyond += counts && crossing.r > frame.disc_y.w ? 1.0 : 0.0;
        covered = covered || (counts && within_disc(crossing.r) && frame.disc_surface.x >= 1.0 && frame.disc_surface.y == 0.0);
#endif
        if (crossed && number > frame.disc_surface.w && crossing.r > max(ray.outer, frame.disc_x.w - rim) && crossing.r < min(SPIN_FARTHEST, frame.disc_y.w + rim)) {
            int slot = trace.crossings;
#ifndef EVERY_CROSSING
            // Light that winds close to a rim may cross the plane beside the disc more often than there are places.
            if (slot >= SPIN_CROSSINGS && !within_disc(trace.crossing_3.r) && within_disc(crossing.r)) slot = 3;
#endif
            if (slot == 0) trace.crossing_0 = crossing;
            if (slot == 1) trace.crossing_1 = crossing;
            if (slot == 2) trace.crossing_2 = crossing;
            if (slot == 3) trace.crossing_3 = crossing;
            ++trace.crossings;
        }
#endif
#ifdef TRACE_STOPS
    } while (going);
#endif
#ifdef NEEDS_PLACE
    trace.solid = solid_found(search);
#endif
    trace.steps = SPIN_MOST_STEPS - left;
    trace.escapes = now.y.w <= 0.0 && trace.energy > 0.0;
#ifdef EFFECT_REFINE
#ifdef EFFECT_DISC
    trace.way = covered ? 0.0 : spin_way(trace.escapes, within, beyond);
#else
    trace.way = spin_way(trace.escapes, 0.0, 0.0);
#endif
#endif
    SpinState sky = spin_to_sky(ray, now);
#ifdef NEEDS_LIGHT_TIMES
    trace.travel_time = sky.travel_time + (sky.afar == AFAR_NOT ? 0.0 : frame.delay.w);
#endif
    vec2 turn = sine_cosine(sky.psi);
    trace.sky =
        trace.escapes ? vec3(turn.y * sky.y.x - turn.x * sky.y.y, turn.x * sky.y.x + turn.y * sky.y.y, sky.y.z) : -n;
#endif
#ifdef NEEDS_FOOTPRINT
    trace.sky_sides.along = dFdx(trace.sky) * sampling_share();
    trace.sky_sides.across = dFdy(trace.sky) * sampling_share();
    vec2 stretched = sides_stretch(trace.sky_sides, trace.pixel_angle);
    trace.stretch_along = stretched.x;
    trace.stretch_across = stretched.y;
#ifdef EFFECT_DISC
    trace.crossing_0 = spin_footprint(trace, 0, trace.crossing_0);
    trace.crossing_1 = spin_footprint(trace, 1, trace.crossing_1);
    trace.crossing_2 = spin_footprint(trace, 2, trace.crossing_2);
    trace.crossing_3 = spin_footprint(trace, 3, trace.crossing_3);
#endif
#ifdef NEEDS_PLACE
    trace.solid_sides.along = dFdx(trace.solid.place.at) * sampling_share();
    trace.solid_sides.across = dFdy(trace.solid.place.at) * sampling_share();
    float met = float(trace.solid.object);
    float side = trace.pixel_angle * search.length;
    if (abs(dFdx(met)) + abs(dFdy(met)) > 0.0) {   // straight light, across it
        vec3 ahead = normalize(trace.solid.place.velocity);
        trace.solid_sides.along = side * normalize(cross(ahead, abs(ahead.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
        trace.solid_sides.across = cross(trace.solid_sides.along, ahead);
    }
#endif
#else
    trace.stretch_along = 1.0;
    trace.stretch_across = 1.0;
#endif
    return trace;
}

#ifdef NEEDS_FOOTPRINT
PixelSides sky_sides(Trace trace) { return trace.sky_sides; }
#ifdef NEEDS_PLACE
PixelSides solid_sides(Trace trace, RayPlace place) { return trace.solid_sides; }
#endif
#endif
