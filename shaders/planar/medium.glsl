// Matter along an orbit, as mino/medium.glsl: by the swept angle.
#include "generated/medium"
#include "medium/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

struct MediumWalk {
    vec3 tangent;     // place_tangent
    float phi;        // where it has come to
    float step;       // length of the next sample, r_s
    int samples;      // that are left
    MediumSum sum;    // of what medium_to() went along
};

MediumWalk medium_walk(Trace trace, vec2 pixel) {
    MediumWalk walk;
    walk.tangent = place_tangent(trace);
    walk.phi = 0.0;
    walk.step = max(frame.medium_bound.y, 1.0 / frame.shift.y - frame.medium_bound.x);
    walk.samples = MEDIUM_MOST_SAMPLES;
    walk.sum = MediumSum(vec3(0.0), 1.0);
    return walk;
}

MediumWalk medium_to(Trace trace, MediumWalk walk, float until) {
    walk.sum = MediumSum(vec3(0.0), 1.0);
    float last = min(until, trace.phi_end);
    if (walk.phi >= last || walk.samples <= 0) return walk;
    float inverse = 1.0 / (trace.doppler * frame.radial.w);
    float energy = energy_at(trace.c) * inverse;
    float momentum = crossed_direction(trace).z / frame.shift.y * inverse;
    float rate = trace.doppler * frame.shift.y / max(trace.s, 1.0e-9);   // of the affine parameter by the angle, over r^2
    RayPlace place = place_of(trace, walk.tangent, walk.phi);
    do {
        float more = min(min(place_part(place, walk.step), MEDIUM_LONGEST), last - walk.phi);
        place = place_of(trace, walk.tangent, walk.phi + 0.5 * more);
        MediumPlace at = MediumPlace(place.at, place.r, place.outward.z, energy, momentum);
        MediumLight found = medium_light(at);
        bool there = place.r > frame.medium_hole.w && place.r < frame.medium_bound.x;
        walk.sum = medium_add(walk.sum, found, there ? rate * place.r * place.r * more : 0.0);
        // Within the innermost matter and on the way out beyond the outermost there is nothing more.
        bool inward = place.r_along < 0.0;
        bool over = inward ? place.r < frame.medium_hole.w : place.r > frame.medium_bound.x;
        walk.phi = over || more >= last - walk.phi ? last : walk.phi + more;
        walk.step = medium_step(found.step * frame.medium_bound.z, more * place_speed(place), frame.medium_bound.y);
        walk.samples -= 1;
    } while (walk.phi < last && walk.sum.through > MEDIUM_LEAST && walk.samples > 0);
    return walk;
}
