// Matter along an orbit, as mino/medium.glsl.
#ifdef EFFECT_LENSING
#include "planar/medium_bent.glsl"
#else
#include "planar/medium_straight.glsl"
#endif
#include "medium/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

struct MediumWalk {
    vec3 tangent;     // place_tangent
    float along;      // where it has come to: medium_at
    RayPlace place;   // there
    float more;       // how much farther a span goes
    RayPlace next;    // and its end
    bool empty;       // no matter there
    int spans;        // that are left
    MediumSum sum;    // of what medium_to() went along
};

MediumWalk medium_walk(Trace trace, vec2 pixel) {
    MediumWalk walk;
    walk.tangent = place_tangent(trace);
    walk.along = medium_start(trace);
    walk.spans = MEDIUM_MOST_SPANS;
    walk.sum = medium_nothing();
    return walk;
}

// To where there may be matter, up to `last`, and the end of a span from there.
MediumWalk medium_on(MediumWalk walk, Trace trace, float last) {
    bool comes = false;
    float before = 1.0e6;
    float length = 1.0e6;   // from there
    do {
        float free = medium_free(walk.place.r, walk.place.outward.z);
        length = medium_jump(free, before, length, walk.place.r);
        before = free;
        // Within the innermost matter and on the way out beyond the outermost there is nothing more.
        bool over = walk.place.r_along < 0.0 ? walk.place.r < frame.medium_hole.w : walk.place.r > frame.medium_bound.x;
        walk.empty = over || free > walk.sum.step;   // a span is longer
        comes = comes || walk.empty;
        float span = max(medium_step(comes, walk.sum.step), frame.medium_bound.y) * float(MEDIUM_SAMPLES);
        float part = medium_part(walk.place, walk.empty ? max(length, frame.medium_bound.y) : span);
        float wedge = medium_to_wedge(walk.place);
        if (walk.empty && wedge > part) {
            part = wedge;
            before = 1.0e6;
            length = 1.0e6;
        }
        walk.more = min(part, last - walk.along);
        walk.next = medium_at(trace, walk.tangent, walk.along + walk.more);
        if (walk.empty) {
            walk.along = !over && walk.more < last - walk.along ? walk.along + walk.more : last;
            walk.place = walk.next;
        }
        walk.spans -= 1;
    } while (walk.empty && walk.along < last && walk.spans > 0);
    walk.sum.step = medium_step(comes, walk.sum.step);
    return walk;
}

// And along the span; of it what medium_to() has not set. rate: medium_rate.
MediumWalk medium_through(MediumWalk walk, Trace trace, MediumSpan span, float rate, float last) {
    float to = walk.along + walk.more;
    walk.place = medium_late(trace, walk.place, walk.along);
    walk.next = medium_next_late(trace, walk.next, to, walk.place, walk.along);
    span.from = walk.place.at;
    span.to = walk.next.at;
    span.from_slope = walk.more * place_velocity(walk.place);
    span.to_slope = walk.more * place_velocity(walk.next);
    span.way = rate * walk.more;
#ifdef NEEDS_PLACE_LATE
    span.delays = vec2(walk.place.delay, walk.next.delay);
#endif
    span = medium_on_ray(span, walk.along, to);
    walk.sum = medium_along(span, walk.sum, walk.empty);
    walk.along = walk.empty ? walk.along : walk.more < last - walk.along ? to : last;
    walk.place = walk.next;
    return walk;
}

MediumWalk medium_to(Trace trace, MediumWalk walk, float until) {
    walk.sum.light = vec3(0.0);
    walk.sum.through = 1.0;
    float last = medium_end(trace, until);
    if (walk.along >= last || walk.spans <= 0) return walk;
    float inverse = 1.0 / (trace.doppler * frame.radial.w);
    MediumSpan span;
    span.by_length = MEDIUM_BY_LENGTH;
    span.turns = vec2(0.0);
    span.energy = energy_at(trace.c) * inverse;
    span.momentum = crossed_direction(trace).z / frame.shift.y * inverse;
    span.pixel_angle = trace.pixel_angle;
    span.camera = radial_direction() / frame.shift.y;
#ifdef MEDIUM_STOKES
    span.phase = trace.screen_phase;
#endif
    float rate = medium_rate(trace);
    walk.place = medium_at(trace, walk.tangent, walk.along);
    do walk = medium_through(medium_on(walk, trace, last), trace, span, rate, last);
    while (walk.along < last && walk.sum.through > frame.medium_colour.w && walk.spans > 0);
    walk.sum.through = medium_rest(walk.sum.through);
    return walk;
}
