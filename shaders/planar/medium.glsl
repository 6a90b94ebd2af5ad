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

MediumWalk medium_to(Trace trace, MediumWalk walk, float until) {
    walk.sum.light = vec3(0.0);
    walk.sum.through = 1.0;
    float last = medium_end(trace, until);
    if (walk.along >= last || walk.spans <= 0) return walk;
    float inverse = 1.0 / (trace.doppler * frame.radial.w);
    float energy = energy_at(trace.c) * inverse;
    float momentum = crossed_direction(trace).z / frame.shift.y * inverse;
    float rate = medium_rate(trace);
    vec3 camera = radial_direction() / frame.shift.y;
    RayPlace place = medium_at(trace, walk.tangent, walk.along);
    do {
        bool empty = false;
#ifdef MEDIUM_OWN_STEPS
        bool comes = false;
#endif
        float before = 1.0e6;
        float length = 1.0e6;   // from there
        do {   // to where there may be matter
            float free = medium_free(place.r, place.outward.z);
            length = medium_jump(free, before, length, place.r);
            before = free;
            float jump = medium_part(place, max(length, frame.medium_bound.y));
            // Within the innermost matter and on the way out beyond the outermost there is nothing more.
            bool over = place.r_along < 0.0 ? place.r < frame.medium_hole.w : place.r > frame.medium_bound.x;
            empty = over || free > walk.sum.step;   // a span is longer
#ifdef MEDIUM_OWN_STEPS
            comes = comes || empty;
#endif
            jump = empty ? jump : 0.0;
            walk.along = over || jump >= last - walk.along ? last : walk.along + jump;
            place = medium_at(trace, walk.tangent, walk.along);
            walk.spans -= 1;
        } while (empty && walk.along < last && walk.spans > 0);
#ifdef MEDIUM_OWN_STEPS
        walk.sum.step = comes ? frame.medium_bound.y : walk.sum.step;   // from outside of it
#endif
        length = max(walk.sum.step, frame.medium_bound.y) * float(MEDIUM_SAMPLES);
        float more = min(medium_part(place, length), last - walk.along);
#ifdef NEEDS_PLACE_LATE
        place = medium_late(trace, place, walk.along);
        RayPlace next = medium_next(trace, walk.tangent, walk.along + more, place, walk.along);
#else
        RayPlace next = medium_at(trace, walk.tangent, walk.along + more);
#endif
        MediumSpan span;
        span.from = place.at;
        span.to = next.at;
        span.from_slope = more * place_velocity(place);
        span.to_slope = more * place_velocity(next);
        span.way = rate * more;
        span.by_length = MEDIUM_BY_LENGTH;
        span.turns = vec2(0.0);
        span.energy = energy;
        span.momentum = momentum;
        span.pixel_angle = trace.pixel_angle;
        span.camera = camera;
#ifdef NEEDS_PLACE_LATE
        span.delays = vec2(place.delay, next.delay);
#endif
#ifdef MEDIUM_MEAN
        span.along = vec2(walk.along, walk.along + more);
#endif
        walk.sum = medium_along(span, walk.sum, empty);
        walk.along = empty ? walk.along : more < last - walk.along ? walk.along + more : last;
        place = next;
    } while (walk.along < last && walk.sum.through > MEDIUM_LEAST && walk.spans > 0);
    return walk;
}
