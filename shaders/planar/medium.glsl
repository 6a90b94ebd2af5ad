// Matter along an orbit, as mino/medium.glsl: by the swept angle.
#include "medium/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

struct MediumWalk {
    vec3 tangent;     // place_tangent
    float phi;        // where it has come to
    int spans;        // that are left
    MediumSum sum;    // of what medium_to() went along
};

MediumWalk medium_walk(Trace trace, vec2 pixel) {
    MediumWalk walk;
    walk.tangent = place_tangent(trace);
    walk.phi = 0.0;
    walk.spans = MEDIUM_MOST_SPANS;
    walk.sum = MediumSum(vec3(0.0), 1.0, frame.medium_bound.y);
    return walk;
}

MediumWalk medium_to(Trace trace, MediumWalk walk, float until) {
    walk.sum.light = vec3(0.0);
    walk.sum.through = 1.0;
    float last = min(until, trace.phi_end);
    if (walk.phi >= last || walk.spans <= 0) return walk;
    float inverse = 1.0 / (trace.doppler * frame.radial.w);
    float energy = energy_at(trace.c) * inverse;
    float momentum = crossed_direction(trace).z / frame.shift.y * inverse;
    float rate = trace.doppler * frame.shift.y / max(trace.s, 1.0e-9);   // of the affine parameter by the angle, over r^2
    vec3 camera = radial_direction() / frame.shift.y;
    RayPlace place = place_of(trace, walk.tangent, walk.phi);
    do {
        bool empty = false;
        float before = 1.0e6;
        float length = 1.0e6;   // from there
        do {   // to where there may be matter
            float free = medium_free(place.r, place.outward.z);
            length = medium_jump(free, before, length, place.r);
            before = free;
            float jump = min(place_part(place, max(length, frame.medium_bound.y)), MEDIUM_LONGEST);
            // Within the innermost matter and on the way out beyond the outermost there is nothing more.
            bool over = place.r_along < 0.0 ? place.r < frame.medium_hole.w : place.r > frame.medium_bound.x;
            empty = over || free > walk.sum.step;   // a span is longer
            jump = empty ? jump : 0.0;
            walk.phi = over || jump >= last - walk.phi ? last : walk.phi + jump;
            place = place_of(trace, walk.tangent, walk.phi);
            walk.spans -= 1;
        } while (empty && walk.phi < last && walk.spans > 0);
        length = max(walk.sum.step, frame.medium_bound.y) * float(MEDIUM_SAMPLES);
        float more = min(min(place_part(place, length), MEDIUM_LONGEST), last - walk.phi);
#ifdef EFFECT_DELAY
#ifdef NEEDS_PLACE_LATE
        // The light-time table once a span.
        place.delay = light_time(trace, walk.phi, place.r, -place.r_along / (place.r * place.r));
        place.time_slope = place_time_slope(trace, place);
        RayPlace next = place_beside(trace, walk.tangent, walk.phi + more, place, walk.phi);
#else
        RayPlace next = place_of(trace, walk.tangent, walk.phi + more);
#endif
#else
        RayPlace next = place_of(trace, walk.tangent, walk.phi + more);
#endif
        MediumSpan span;
        span.from = place.at;
        span.to = next.at;
        span.from_slope = more * place_velocity(place);
        span.to_slope = more * place_velocity(next);
        span.way = rate * more;
        span.energy = energy;
        span.momentum = momentum;
        span.pixel_angle = trace.pixel_angle;
        span.camera = camera;
#ifdef NEEDS_PLACE_LATE
        span.delays = vec2(place.delay, next.delay);
#endif
        walk.sum = medium_along(span, walk.sum, empty);
        walk.phi = empty ? walk.phi : more < last - walk.phi ? walk.phi + more : last;
        place = next;
    } while (walk.phi < last && walk.sum.through > MEDIUM_LEAST && walk.spans > 0);
    return walk;
}
