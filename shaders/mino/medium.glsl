// Matter along a ray about a rotating hole: the ray's steps once more (mino/trace.glsl), and samples within those that come near it.
#include "generated/medium"
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
    float step;           // length of the next sample, r_s
    int left;             // steps of the ray
    int samples;
    bool outside;         // of the horizon
    bool ends;            // the step is the ray's last
    bool going;
    float doppler;
    MediumSum sum;        // of what medium_to() went along
};

MediumWalk medium_walk(Trace trace, vec2 pixel) {
    SpinView view = spin_view(pixel);
    MediumWalk walk;
    walk.ray = spin_ray(view);
    walk.now = spin_start(walk.ray, view.direction);
    walk.segment = spin_segment(walk.ray, walk.now, walk.now, 0.0);
    walk.begun = 0.0;
    walk.ended = 0.0;
    walk.part = 1.0;
    walk.step = frame.medium_bound.y;
    walk.left = SPIN_MOST_STEPS;
    walk.samples = MEDIUM_MOST_SAMPLES;
    walk.outside = true;
    walk.ends = false;
    walk.going = true;
#ifdef EFFECT_SPIN_FALL
    walk.outside = frame.shift.y * walk.ray.outer < 1.0;
    walk.going = walk.outside || walk.ray.a * walk.ray.momentum > walk.ray.energy * (walk.ray.outer - frame.spin_turn.z);   // mino/trace.glsl
#endif
    walk.doppler = view.doppler;
    walk.sum = MediumSum(vec3(0.0), 1.0);
    return walk;
}

// The next step of the ray that comes near matter, or its last.
MediumWalk medium_next(MediumWalk walk) {
    SpinState from = walk.now;
    float h = 0.0;
    float end = 1.0 / walk.ray.outer;
    bool near = false;
    do {
        from = walk.now;
        walk.begun = walk.ended;
        h = spin_step_length(walk.ray, from, walk.left);
        walk.now = spin_step(walk.ray, from, h);
        walk.ended += h;
        walk.left -= 1;
#ifdef EFFECT_SPIN_FALL
        walk.outside = walk.outside || walk.now.y.w < end;
#endif
        walk.ends = !spin_goes(walk.now.y.w, end, walk.left, walk.outside);
        float more = 0.25 * h * max(abs(from.v.w), abs(walk.now.v.w));   // where zeta turns within it
        near = (max(from.y.w, walk.now.y.w) + more) * frame.medium_bound.x >= 1.0;
    } while (!walk.ends && !near);
    walk.segment = spin_segment(walk.ray, from, walk.now, h);
    walk.part = near ? 0.0 : 1.0;
    walk.step = max(walk.step, 1.0 / from.y.w - frame.medium_bound.x);
    return walk;
}

// Along the ray from where the walk has come to, up to Mino's time `until`.
MediumWalk medium_to(Trace trace, MediumWalk walk, float until) {
    walk.sum = MediumSum(vec3(0.0), 1.0);
    float inverse = 1.0 / walk.doppler;
    do {
        if (walk.part >= 1.0) walk = medium_next(walk);
        float h = walk.segment.h;
        float last = min((until - walk.begun) / max(h, 1.0e-20), 1.0);
        if (walk.part < last) {
            RayPlace place = segment_place(walk.ray, walk.segment, walk.part);
            do {
                float more = min(min(place_part(place, walk.step), MEDIUM_LONGEST), last - walk.part);
                place = segment_place(walk.ray, walk.segment, walk.part + 0.5 * more);
                MediumPlace at = MediumPlace(place.at, place.r, place.outward.z, trace.energy * inverse, trace.momentum * inverse);
                MediumLight found = medium_light(at);
                float az = walk.ray.a * place.outward.z;
                float way = (place.r * place.r + az * az) * h * more * walk.doppler;
                bool there = place.r > frame.medium_hole.w && place.r < frame.medium_bound.x;
                walk.sum = medium_add(walk.sum, found, there ? way : 0.0);
                walk.part = more < last - walk.part ? walk.part + more : last;
                walk.step = medium_step(found.step * frame.medium_bound.z, more * place_speed(place), frame.medium_bound.y);
                walk.samples -= 1;
                // On its way in nothing follows the innermost matter.
                walk.going = walk.going && (place.r > frame.medium_hole.w || dot(place.velocity, place.outward) > 0.0);
            } while (walk.part < last && walk.going && walk.sum.through > MEDIUM_LEAST && walk.samples > 0);
        }
        walk.going = walk.going && walk.samples > 0 && !(walk.ends && walk.part >= 1.0);
    } while (walk.going && walk.sum.through > MEDIUM_LEAST && walk.begun + walk.part * walk.segment.h < until * (1.0 - 1.0e-6));
    return walk;
}
