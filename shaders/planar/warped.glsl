// A disc whose rings lie in planes of their own, as a ray in a plane meets it: at swept angles where n(r(phi)) . x(phi) is 0, n the normal of the
// ring at the ray's radius (object/disc_shape.glsl). A ray may do so any number of times. It is followed in steps short beside the disc's own
// radii; one that dips through the disc and comes back is taken in two. Once per ray as planar/disc_walk.glsl for flat discs.
#ifdef EFFECT_LENSING
#include "core/orbit.glsl"
#endif
#include "core/plane_search.glsl"
#include "core/trig.glsl"
#include "object/disc_rim.glsl"
#include "object/disc_shape.glsl"
#include "planar/disc_hit.glsl"
#include "planar/trace.glsl"
#ifdef EFFECT_REFINE
#include "shared/fragment_at.glsl"
#endif
#include "shared/frame.glsl"

#ifdef NEEDS_FOOTPRINT
#define WARPED_MARGIN 0.5      // px by which rims are widened, for pixels that are covered in part
#else
#define WARPED_MARGIN 0.0
#endif
#define WARPED_ON 4.0e-7       // heights below are roundings: a camera or a ray in the disc
#define WARPED_NEAR 1.0e-3     // heights that a step may be off by between its ends
#define WARPED_PART 0.002      // of a step: deeper dips than WARPED_ON are not closer to its start
#define WARPED_TURN 0.3        // rad, a step's longest
#define WARPED_SHARE 0.15      // ... and by the change of ln r: kSteepestWarp turns a ring by 0.6 rad on it
#define WARPED_STEPS 240
#define WARPED_THIN_PX 6.0     // from the critical direction; further out rings are 3 px wide and more
#define WARPED_AROUND 1.3      // of a rim: the disc's table ends within, and with it all that a ray may meet
#define WARPED_LONGEST 64.0    // of the outer radius: a longer footprint shows no less of the disc
#define WARPED_GRAZING 1.0e-5  // slopes of the height below are of rays along the disc, whose footprint has no end

struct WarpedPlace {
    float phi;
    float zeta;
    float along;      // d zeta / d phi at fixed view direction
    float across;     // d zeta / d |delta| at fixed phi
    vec2 height;      // over the ring of this radius, of a unit vector; its slope by phi
};

vec3 warped_forward(Trace trace) { return sideways(trace.side) / trace_sine(trace); }

WarpedPlace warped_at(Trace trace, float phi) {
    WarpedPlace at;
    at.phi = phi;
    vec2 swept = sine_cosine(phi);
    float c = swept.y;
    float s = swept.x;
#ifdef EFFECT_LENSING
    OrbitPoint point = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, phi, trace.phi_end, trace.phi_end_slope);
    at.zeta = max(point.zeta, 1.0e-12);
    at.along = point.along;
    at.across = point.across;
#else
    float scale = frame.shift.y / trace_sine(trace);
    at.zeta = max(scale * (trace_sine(trace) * c - trace.c * s), 1.0e-12);
    at.along = -scale * (trace_sine(trace) * s + trace.c * c);
    at.across = scale * s / trace_sine(trace);
#endif
    DiscRing ring = disc_ring(1.0 / at.zeta);
    vec3 forward = warped_forward(trace);
    vec3 outward = c * radial_direction() + s * forward;
    vec3 ahead = c * forward - s * radial_direction();
    float height = dot(ring.normal, outward);
    at.height = vec2(abs(height) < WARPED_ON ? 0.0 : height, dot(ring.normal, ahead) - at.along / at.zeta * dot(ring.slope, outward));
    return at;
}

bool warped_crosses(WarpedPlace from, WarpedPlace to) { return from.height.x * to.height.x < 0.0 || (to.height.x == 0.0 && from.height.x != 0.0); }

// A step, or its part to where it is lowest over the disc, or beyond it: a cubic is not sure of less than WARPED_NEAR.
WarpedPlace warped_step(Trace trace, WarpedPlace from) {
    float h = min(WARPED_TURN, WARPED_SHARE * from.zeta / max(abs(from.along), 1.0e-20));
    h = min(h, trace.phi_end - from.phi);
    WarpedPlace to;
    float part = 1.0;
    bool again;
    do {   // tested at the end, see disc_cover
        again = part < 1.0;
        h *= part;
        to = warped_at(trace, from.phi + h);
        part = plane_dip(vec2(from.height.x, h * from.height.y), vec2(to.height.x, h * to.height.y), -WARPED_NEAR);
        part = part < WARPED_PART ? 1.0 : part;
    } while (part < 1.0 && !again);
    return to;
}

// May the disc be ahead?
bool warped_goes(Trace trace, WarpedPlace at) {
    bool leaves = trace.escapes && at.along < 0.0 && at.zeta * (WARPED_AROUND * frame.disc_y.w) < 1.0;
    bool falls = !trace.escapes && at.along > 0.0 && at.zeta * frame.disc_x.w > WARPED_AROUND;
    return at.phi < trace.phi_end && !leaves && !falls;
}

struct DiscWalk {
    bool more;            // is there this crossing?
    int number;
    float covered;        // part of the pixel: all of it
    int left;             // steps
    WarpedPlace now;
    WarpedPlace from;     // of the step that crosses
    WarpedPlace to;
};

// To the next crossing.
DiscWalk warped_walk(Trace trace, DiscWalk walk) {
    bool going = warped_goes(trace, walk.now) && walk.left > 0;
    walk.more = false;
    walk.number += 1;
    if (going) {
        do {
            WarpedPlace before = walk.now;
            walk.now = warped_step(trace, before);
            --walk.left;
            if (warped_crosses(before, walk.now)) {   // kept in a branch, see mino/walk.glsl
                walk.from = before;
                walk.to = walk.now;
                walk.more = true;
            }
            going = warped_goes(trace, walk.now) && walk.left > 0;
        } while (going && !walk.more);
    }
    return walk;
}

// Crossings that the frame leaves out.
DiscWalk warped_passed(Trace trace, DiscWalk walk) {
    while (walk.more && float(walk.number) < frame.disc_surface.w) walk = warped_walk(trace, walk);
    return walk;
}

// Up to where the ray may come close to the disc, it is over a plane: |d zeta / d phi| <= q.
DiscWalk disc_walk(Trace trace) {
    DiscWalk walk;
    WarpedPlace start = warped_at(trace, 0.0);
    float q = q_sine(trace.c);
    float far = trace.s * (1.0 / (WARPED_AROUND * frame.disc_y.w) - frame.shift.y);
    float skipped = q > 0.0 ? min(max(far, 0.0) / max(q, 1.0e-20), trace.phi_end) : 0.0;
    walk.now = warped_at(trace, skipped);
    walk.number = warped_crosses(start, walk.now) ? 0 : -1;
    walk.covered = 1.0;
    walk.left = WARPED_STEPS;
    walk.from = start;
    walk.to = start;
    return warped_passed(trace, warped_walk(trace, walk));
}

DiscWalk disc_next(Trace trace, DiscWalk walk) { return warped_walk(trace, walk); }

// A pixel's side turns the ray's place by `moved` and its zeta by `change`, at a fixed swept angle: what that is on the disc, where the angle has to
// change too.
vec3 warped_side(WarpedPlace at, vec3 normal_slope, vec3 normal, vec3 outward, vec3 ahead, vec3 moved, float change) {
    float r = 1.0 / at.zeta;
    float up = dot(normal, moved) - change * r * dot(normal_slope, outward);
    float slope = abs(at.height.y) > WARPED_GRAZING ? at.height.y : WARPED_GRAZING;
    float turn = -up / slope;
    vec3 side = r * (moved + turn * ahead) - r * r * (change + turn * at.along) * outward;
    float longest = WARPED_LONGEST * frame.disc_y.w;
    return clamp(side, vec3(-longest), vec3(longest));
}

DiscCrossing disc_walk_crossing(Trace trace, DiscWalk walk) {
    float h = walk.to.phi - walk.from.phi;
    vec2 begin = vec2(walk.from.height.x, h * walk.from.height.y);
    PlaneSearch search = plane_search(begin, vec2(walk.to.height.x, h * walk.to.height.y));
    WarpedPlace at = walk.to;
    int left = 3;
    do {
        at = warped_at(trace, walk.from.phi + search.s * h);
        search = plane_narrowed(search, vec2(at.height.x, h * at.height.y), begin.x);
    } while (--left > 0);
    at = warped_at(trace, walk.from.phi + search.s * h);
    DiscCrossing crossing;
    crossing.phi = at.phi;
    crossing.r = 1.0 / at.zeta;
#ifdef NEEDS_ZETA_SLOPE
    crossing.zeta_slope = at.along;
#endif
    vec3 forward = warped_forward(trace);
    vec2 swept = sine_cosine(at.phi);
    vec3 outward = swept.y * radial_direction() + swept.x * forward;
    vec3 ahead = swept.y * forward - swept.x * radial_direction();
    DiscAxes axes = disc_axes(crossing.r);
    DiscRing ring = disc_ring(crossing.r);
    float pixel = trace.pixel_angle;
    vec3 along = warped_side(at, ring.slope, ring.normal, outward, ahead, vec3(0.0), at.across * pixel);
    vec3 around = cross(radial_direction(), forward) * (swept.x * pixel / trace_sine(trace));
    vec3 across = warped_side(at, ring.slope, ring.normal, outward, ahead, around, 0.0);
    crossing.along = vec2(dot(axes.x, along), dot(axes.y, along));
    crossing.across = vec2(dot(axes.x, across), dot(axes.y, across));
    crossing.place = crossing.r * vec2(dot(axes.x, outward), dot(axes.y, outward));
    crossing.axis = axes.normal;
    crossing.outward = outward;
    float reach = min(WARPED_MARGIN * length(vec2(dot(along, outward), dot(across, outward))), disc_rim());
    crossing.hit = disc_has(crossing.r, reach);
    return crossing;
}

vec3 crossing_axis(DiscCrossing crossing) { return crossing.axis; }
vec3 crossing_place_in_world(DiscCrossing crossing) { return crossing.r * crossing.outward; }

#ifdef EFFECT_REFINE
// Images of high order are rings thinner than a pixel next to the critical direction: there all pixels differ from their neighbours.
#ifdef EFFECT_LENSING
float path_way(Trace trace) {
    ivec2 place = ivec2(fragment_at());
    bool near = abs(trace.ray.u - 1.0) < WARPED_THIN_PX * trace.pixel_angle * frame.strip.z;
    return near ? 1.0 + float((place.x + place.y) % 2) : 0.0;
}
#else
float path_way(Trace trace) { return 0.0; }
#endif
#endif

#ifdef LAYERS
// 0: the direct image.
int disc_walk_order(DiscWalk walk, DiscCrossing crossing) { return walk.number; }
#endif
