// Matter along a ray about a rotating hole: the ray's steps once more (mino/walk.glsl), and samples within those that come near it.
#include "medium/march.glsl"
#include "mino/place.glsl"
#include "mino/ray.glsl"
#include "mino/segment.glsl"
#include "mino/step.glsl"
#include "mino/trace.glsl"
#include "shared/frame.glsl"

struct MediumWalk {
    SpinRay ray;
    SpinState now;        // at the end of the step
    SpinSegment segment;  // the step
    float begun;          // Mino's time where it begins, and where it ends
    float ended;
    float part;           // of the step that is done
    RayPlace place;       // there
    float turn;           // medium_turn() there
    float more;           // of the step, that a span from there takes
    RayPlace next;        // its end
    float next_turn;
    bool empty;           // no matter there
    int left;             // steps of the ray
    int spans;
    bool outside;         // of the horizon
    bool ends;            // the step is the ray's last
    bool going;
    float doppler;
    MediumSum sum;        // of what medium_to() went along
};

// In place of segment_place(): without the azimuth that the hole's rotation adds, which winds up next to the horizon. What has MEDIUM_AZIMUTH ends before that.
RayPlace medium_place(SpinRay ray, SpinSegment segment, float s) {
#ifndef MEDIUM_AZIMUTH
    vec4 y = spin_at(segment.arc, s);
    vec4 slope = spin_slope_at(segment.arc, s);
    RayPlace place;
    place.r = 1.0 / max(y.w, 1.0e-10);
    place.outward = vec3(y.x, y.y, y.z);
    place.at = place.r * place.outward;
    place.velocity = place.r * (vec3(slope.x, slope.y, slope.z) - (slope.w * place.r) * place.outward);
#ifdef NEEDS_PLACE_TIME
    place.light_time = 0.0;
#endif
#ifdef NEEDS_PLACE_LATE
    place.delay = 0.0;
#ifdef EFFECT_DELAY
    place.delay = segment_delay(ray, segment, s, y);
#endif
#endif
    return place;
#else
    return segment_place(ray, segment, s);
#endif
}

// That azimuth, where matter is not the same all round: Boyer and Lindquist's, or Kerr and Schild's where a grid has it.
float medium_turn(SpinRay ray, SpinSegment segment, float s) {
#ifdef MEDIUM_TURN
    vec4 y = spin_at(segment.arc, s);
    float turned = segment_turned(ray, segment, s, y);
#ifdef EFFECT_MEDIUM_GRID
    turned -= GRID_KERR_SCHILD * spin_winding(ray, y.w, spin_fine_at(segment.arc, s, y.w));
#endif
    return turned;
#else
    return 0.0;
#endif
}

MediumWalk medium_walk(Trace trace, vec2 pixel) {
    SpinView view = spin_view(pixel);
    MediumWalk walk;
    walk.ray = spin_ray(view);
    walk.now = spin_start(walk.ray, view.direction);
    walk.segment = spin_segment(walk.ray, walk.now, walk.now, 0.0);
    walk.begun = 0.0;
    walk.ended = 0.0;
    walk.part = 1.0;
    walk.left = SPIN_MOST_STEPS;
    walk.spans = MEDIUM_MOST_SPANS;
    walk.outside = starts_outside(walk.ray);
    walk.ends = false;
    walk.going = sees_ours(walk.ray, walk.outside);
    walk.doppler = view.doppler;
    walk.sum = medium_nothing();
    return walk;
}

bool medium_near(SpinState from, SpinState to, float h) {
    float more = 0.25 * h * max(abs(from.v.w), abs(to.v.w));   // where zeta turns within it
    return (max(from.y.w, to.y.w) + more) * frame.medium_bound.x >= 1.0;
}

// The next step of the ray that comes near matter, or its last.
MediumWalk medium_next(MediumWalk walk) {
    SpinState from = walk.now;
    SpinState to = walk.now;
    float taken = 0.0;
    float end = 1.0 / walk.ray.outer;
    bool near = false;
    bool going = true;
    do {
        SpinState before = walk.now;
        float h = spin_step_length(walk.ray, before, walk.left);
        walk.now = spin_step(walk.ray, before, h);
        walk.ended += h;
        walk.left -= 1;
        walk.outside = comes_outside(walk.outside, walk.now.y.w, end);
        near = medium_near(before, walk.now, h);
        going = spin_goes(walk.now.y.w, end, walk.left, walk.outside);
        if (near || !going) {   // in a branch: see mino/walk.glsl
            from = before;
            to = walk.now;
            taken = h;
        }
    } while (going && !near);
    walk.begun = walk.ended - taken;
    walk.ends = !spin_goes(walk.now.y.w, end, walk.left, walk.outside);
    walk.segment = spin_segment(walk.ray, from, to, taken);
    walk.part = medium_near(from, to, taken) ? 0.0 : 1.0;
    return walk;
}

// To where there may be matter, up to the part `last` of the step, and the end of a span from there.
MediumWalk medium_on(MediumWalk walk, float last) {
    bool comes = false;
    float before = 1.0e6;
    float length = 1.0e6;   // from there
    do {
        float free = medium_free(walk.place.r, walk.place.outward.z);
        length = medium_jump(free, before, length, walk.place.r);
        before = free;
        // On its way out beyond the outermost matter nothing more follows.
        bool over = walk.place.r > frame.medium_bound.x && dot(walk.place.velocity, walk.place.outward) > 0.0;
        walk.empty = over || free > walk.sum.step;   // a span is longer
        comes = comes || walk.empty;
        float way = max(walk.empty ? length : medium_step(comes, walk.sum.step), frame.medium_bound.y) * (walk.empty ? 1.0 : float(MEDIUM_SAMPLES));
        walk.more = min(min(place_part(walk.place, way), medium_longest()), last - walk.part);
        walk.next = medium_place(walk.ray, walk.segment, walk.part + walk.more);
        walk.next_turn = medium_turn(walk.ray, walk.segment, walk.part + walk.more);
        if (walk.empty) {
            walk.part = !over && walk.more < last - walk.part ? walk.part + walk.more : last;
            walk.place = walk.next;
            walk.turn = walk.next_turn;
        }
        walk.spans -= 1;
    } while (walk.empty && walk.part < last && walk.spans > 0);
    walk.sum.step = medium_step(comes, walk.sum.step);
    return walk;
}

// And along the span; of it what medium_to() has not set.
MediumWalk medium_through(MediumWalk walk, MediumSpan span, float last) {
    float to = walk.part + walk.more;
    span.from = walk.place.at;
    span.to = walk.next.at;
    span.from_slope = walk.more * walk.place.velocity;
    span.to_slope = walk.more * walk.next.velocity;
    span.way = walk.segment.h * walk.more * walk.doppler;
    span.turns = vec2(walk.turn, walk.next_turn);
#ifdef NEEDS_PLACE_LATE
    span.delays = vec2(walk.place.delay, walk.next.delay);
#endif
    span = medium_on_ray(span, walk.begun + walk.segment.h * walk.part, walk.begun + walk.segment.h * to);
    walk.sum = medium_along(span, walk.sum, walk.empty);
    walk.part = walk.empty ? walk.part : walk.more < last - walk.part ? to : last;
    walk.place = walk.next;
    walk.turn = walk.next_turn;
    // Nor on its way in within the innermost.
    bool outward = dot(walk.place.velocity, walk.place.outward) > 0.0;
    walk.going = walk.going && (outward ? walk.place.r < frame.medium_bound.x || walk.part < last : walk.place.r > frame.medium_hole.w);
    return walk;
}

// Along the step.
MediumWalk medium_in_step(MediumWalk walk, MediumSpan span, float last) {
    walk.place = medium_place(walk.ray, walk.segment, walk.part);
    walk.turn = medium_turn(walk.ray, walk.segment, walk.part);
    do walk = medium_through(medium_on(walk, last), span, last);
    while (walk.part < last && walk.going && walk.sum.through > frame.medium_colour.w && walk.spans > 0);
    return walk;
}

// Along the ray from where the walk has come to, up to Mino's time `until`.
MediumWalk medium_to(Trace trace, MediumWalk walk, float until) {
    walk.sum.light = vec3(0.0);
    walk.sum.through = 1.0;
    float inverse = 1.0 / walk.doppler;
    MediumSpan span;
    span.by_length = false;
    span.energy = trace.energy * inverse;
    span.momentum = trace.momentum * inverse;
    span.pixel_angle = trace.pixel_angle;
    span.camera = vec3(frame.spin_place.x * frame.spin_place.z, frame.spin_place.x * frame.spin_place.w, frame.spin_place.y) / frame.shift.y;
#ifdef MEDIUM_STOKES
    span.phase = trace.screen_phase;
#endif
    do {
        if (walk.part >= 1.0) walk = medium_next(walk);
        float last = min((until - walk.begun) / max(walk.segment.h, 1.0e-20), 1.0);
        if (walk.part < last) walk = medium_in_step(walk, span, last);
        walk.going = walk.going && walk.spans > 0 && !(walk.ends && walk.part >= 1.0);
    } while (walk.going && walk.sum.through > frame.medium_colour.w && walk.begun + walk.part * walk.segment.h < until * (1.0 - 1.0e-6));
    walk.sum.through = medium_rest(walk.sum.through);
    return walk;
}
