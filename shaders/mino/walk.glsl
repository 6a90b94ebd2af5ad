// The steps of a ray about a rotating hole, and what it meets on them: from one that meets something, which is then looked at once for all of the
// driver's rays, to the next. Loops are tested at the end, see object/disc_cover.glsl.
#include "mino/kept_crossings.glsl"
#include "mino/ray.glsl"
#ifdef NEEDS_PLACE
#include "mino/march.glsl"
#else
#include "mino/no_march.glsl"
#endif
#include "mino/step.glsl"
#include "shared/frame.glsl"
#ifdef EFFECT_DISC_LEAN
#include "mino/leaning.glsl"
#else
#define next_step(ray, from, h) spin_step(ray, from, h)
#define state_turned(ray, now) now
#endif

struct SpinWalk {
    SpinState now;
    float tau;            // Mino's time there
    int left;             // steps
    bool outside;         // of the horizon, or has been
    bool ours;            // may meet what is ours
    bool going;
    SpinStep met;         // the last step that may have met something
    KeptCrossings kept;
    SolidSearch search;
};

SpinWalk walk_start(SpinRay ray, vec3 n, float pixel_angle) {
    SpinWalk walk;
    walk.now = spin_start(ray, n);
    walk.tau = 0.0;
    walk.left = SPIN_MOST_STEPS;
    walk.outside = starts_outside(ray);
    walk.ours = sees_ours(ray, walk.outside);
    walk.going = true;
    walk.met = step_from(walk.now);
    walk.kept = kept_none();
    walk.search = solid_search(walk.ours, pixel_angle);
    return walk;
}

#ifdef EFFECT_ZOOM
// Half of its way: from here on all that the picture leaves out is behind the ray.
SpinWalk walk_left_out(SpinWalk walk, SpinRay ray, SpinState before) {
    if (ring_leaves(ray, before, walk.now)) {
        walk.now.psi += frame.ring.x;
        walk.kept.number += frame.ring.z;
#ifdef NEEDS_LIGHT_TIMES
        walk.now.travel_time += frame.ring.y;
#endif
    }
    return walk;
}
#else
SpinWalk walk_left_out(SpinWalk walk, SpinRay ray, SpinState before) { return walk; }
#endif

// To a step that may meet something, by its ends, or to the ray's end.
SpinWalk walk_steps(SpinWalk walk, SpinRay ray) {
    float end = 1.0 / ray.outer;
    walk.met.crosses = false;
    walk.met.near = false;
    do {
        SpinState before = walk.now;
        float h = spin_step_length(ray, before, walk.left);
        walk.now = next_step(ray, before, h);
        walk = walk_left_out(walk, ray, before);
        --walk.left;
        bool crosses = step_crosses(before, walk.now);
        walk.search = search_passes(walk.search, before, walk.now, h);
        // What is used after the loop is kept in a branch: Mesa 22's software driver gives a ray that has left a loop what later rounds
        // of the others make of variables that no round takes over from the one before.
        if (crosses || walk.search.meets) {
            walk.met.from = before;
            walk.met.to = walk.now;
            walk.met.h = h;
            walk.met.begun = walk.tau;
            walk.met.crosses = crosses;
            walk.met.near = walk.search.meets;
        }
        walk.now = state_turned(ray, walk.now);
        walk.tau += h;
        walk.outside = comes_outside(walk.outside, walk.now.y.w, end);
        walk.going = spin_goes(walk.now.y.w, end, walk.left, walk.outside);
    } while (walk.going && !walk.met.crosses && !walk.met.near);
    walk.going = spin_goes(walk.now.y.w, end, walk.left, walk.outside);
    return walk;
}

#ifdef NEEDS_PLACE
// Likewise, by its middle too where bodies may be near.
SpinWalk walk_closer(SpinWalk walk, SpinRay ray) {
    do {
        walk = walk_steps(walk, ray);
        if (walk.met.near && !step_touches(ray, walk.met.from, walk.met.to, walk.met.h)) {
            walk.met.near = false;
            walk.search.length = length_behind(walk.search, walk.met.from, walk.met.to);
        }
    } while (walk.going && !walk.met.crosses && !walk.met.near);
    if (walk.met.near) {
        walk.search = step_search(ray, walk.met, walk.search);
        walk.now.psi = walk.search.psi;
    }
    return walk;
}
#else
SpinWalk walk_closer(SpinWalk walk, SpinRay ray) { return walk_steps(walk, ray); }
#endif

// To the end of the ray.
SpinWalk walk_all(SpinWalk walk, SpinRay ray) {
    do {
        walk = walk_closer(walk, ray);
        walk.kept = kept_with(walk.kept, ray, walk.met, walk.ours);
    } while (walk.going);
    return walk;
}
