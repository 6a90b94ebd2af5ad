// How far away a place on a ray about a rotating hole is, as planar/depth.glsl. In Mino's time the affine parameter grows by
// r^2 + a^2 n_z^2, and with zeta'^2 = E^2 + (a^2 E^2 - J^2) zeta^2 + K zeta^3 - (a^2 Q + c K) zeta^4
//     E^2 int r^2 dtau = [-zeta'/zeta] + int (K zeta/2 - (a^2 Q + c K) zeta^2) dtau
#ifdef MEDIUM_MEAN
#include "mino/place.glsl"
#endif
#include "mino/ray.glsl"
#include "mino/segment.glsl"
#include "mino/step.glsl"
#include "mino/trace.glsl"
#include "shared/frame.glsl"

#define DEPTH_LEAST_ENERGY 1.0e-3   // of the photon: below it, next to the horizon of a fast hole, depths are too small

float depth_rate(SpinRay ray, vec4 y, float inverse_e2) {
    return y.w * (0.5 * ray.k - ray.cubic * y.w) * inverse_e2 + ray.a * ray.a * y.z * y.z;
}

struct DepthWalk {
    SpinRay ray;
    SpinState from;   // the last step, which ends at the place
    SpinState to;
    float h;
    float depth;
};

// To Mino's time `along`: by the ray's steps once more, and Lobatto's rule within each.
DepthWalk depth_walk(vec2 pixel, float along) {
    SpinView view = spin_view(pixel);
    SpinRay ray = spin_ray(view);
    SpinState start = spin_start(ray, view.direction);
    float energy = max(-ray.energy, DEPTH_LEAST_ENERGY);
    float inverse_e2 = 1.0 / (energy * energy);
    DepthWalk walk;
    SpinState now = start;
    float sum = 0.0;
    float tau = 0.0;
    int left = SPIN_MOST_STEPS;
    do {
        float h = max(min(spin_step_length(ray, now, left), along - tau), 1.0e-9);
        SpinState to = spin_step(ray, now, h);
        SpinArc arc = spin_arc(now, to, h);
        sum += h * (0.05 * (depth_rate(ray, now.y, inverse_e2) + depth_rate(ray, to.y, inverse_e2)) +
                    (49.0 / 180.0) * (depth_rate(ray, spin_at(arc, LOBATTO_POINT), inverse_e2) + depth_rate(ray, spin_at(arc, 1.0 - LOBATTO_POINT), inverse_e2)) +
                    (16.0 / 45.0) * depth_rate(ray, spin_at(arc, 0.5), inverse_e2));
        walk.from = now;
        walk.h = h;
        now = to;
        tau += h;
        --left;
    } while (tau < along * (1.0 - 1.0e-6) && left > 0);
    walk.ray = ray;
    walk.to = now;
    walk.depth = view.doppler * ((start.v.w / max(start.y.w, 1.0e-12) - now.v.w / max(now.y.w, 1.0e-12)) * inverse_e2 + sum);
    return walk;
}

float affine_depth(vec2 pixel, Trace trace, float along) { return depth_walk(pixel, along).depth; }

#ifdef MEDIUM_MEAN
// Of a place in matter, by where the walk through it has it: x, y, z, r_s, and its depth.
vec4 medium_depth(vec2 pixel, Trace trace, float along) {
    DepthWalk walk = depth_walk(pixel, along);
    return vec4(segment_place(walk.ray, spin_segment(walk.ray, walk.from, walk.to, walk.h), 1.0).at, walk.depth);
}
#endif
