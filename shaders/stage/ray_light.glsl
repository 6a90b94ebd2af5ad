// What a ray meets, front to back; where the scene has no such thing, functions that do nothing.
#ifdef NEEDS_PLACE
#include "generated/bodies_hit"
#include "generated/bodies_light"
#endif
#ifdef EFFECT_DISC
#include "object/disc_colour.glsl"
#include "path/disc"
#endif
#ifdef EFFECT_SKY
#include "object/celestial_sphere.glsl"
#else
#ifdef EFFECT_FAR_SKY
#include "object/celestial_sphere.glsl"
#include "object/other_side.glsl"
#endif
#endif
#ifdef EFFECT_SKY_PATTERN
#include "object/sky_pattern.glsl"
#endif
#ifdef EFFECT_STAR
#include "object/star.glsl"
#endif
#ifdef SLOT_MEDIUM
#include "path/medium"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/layer.glsl"

#define SIGHT_LEAST 2.0e-7   // of the light behind: less is not looked for; an opaque cover leaves as much by rounding

// What is seen so far.
struct RaySight {
    vec3 light;
    float through;        // of the light behind
#ifdef NEEDS_PLACE
    SolidHit solid;       // the first solid body: met once, laid between the disc's crossings before and behind it
    vec4 body;            // its light and cover; 0 once it is laid
#endif
#ifdef SLOT_MEDIUM
    MediumWalk medium;
#endif
    vec2 stokes;          // Q and U
};

#ifdef NEEDS_STOKES
RaySight with_stokes(RaySight sight, float share) {
    sight.stokes += share > 0.0 ? share * disc_stokes : vec2(0.0);   // of no crossing it may be no number
    return sight;
}
vec3 sight_light(RaySight sight) { return layer_shown == LAYER_STOKES ? vec3(sight.stokes, 0.0) : sight.light; }
#else
RaySight with_stokes(RaySight sight, float share) { return sight; }
vec3 sight_light(RaySight sight) { return sight.light; }
#endif

#ifdef NEEDS_PLACE
RaySight sight_of_solid(RaySight sight, Trace trace) {
    sight.solid = solid_hit(trace, 1.0);
    sight.body = sight.solid.object == 0 ? vec4(0.0) : vec4(solid_light(trace, sight.solid), 1.0) * sight.solid.covered;
    return sight;
}

float before_solid(RaySight sight, float along) { return min(along, sight.solid.phi); }

RaySight with_solid(RaySight sight) {
    sight.light += layer_light(sight.through * sight.body.rgb, sight.through * sight.body.a, LAYER_BODIES);
    sight.through -= sight.through * sight.body.a;
    return sight;
}

// If it lies before a place on the ray.
RaySight with_solid_before(RaySight sight, float along) {
    if (along > sight.solid.phi) {
        sight = with_solid(sight);
        sight.body = vec4(0.0);
    }
    return sight;
}
#else
RaySight sight_of_solid(RaySight sight, Trace trace) { return sight; }
float before_solid(RaySight sight, float along) { return along; }
RaySight with_solid_before(RaySight sight, float along) { return sight; }
#endif

#ifdef SLOT_MEDIUM
RaySight sight_of_matter(RaySight sight, Trace trace, vec2 pixel) {
    sight.medium = medium_walk(trace, pixel);
    return sight;
}

// Matter along the ray as far as a place on it.
RaySight with_matter(RaySight sight, Trace trace, float until) {
    sight.medium = medium_to(trace, sight.medium, until);
    sight.light += layer_light(sight.through * sight.medium.sum.light, sight.through - sight.through * sight.medium.sum.through, LAYER_MEDIUM);
    sight.through *= sight.medium.sum.through;
    return sight;
}

RaySight with_matter_behind(RaySight sight, Trace trace) {
    if (sight.through > SIGHT_LEAST) sight = with_matter(sight, trace, 1.0e30);
    return sight;
}
#else
RaySight sight_of_matter(RaySight sight, Trace trace, vec2 pixel) { return sight; }
RaySight with_matter(RaySight sight, Trace trace, float until) { return sight; }
RaySight with_matter_behind(RaySight sight, Trace trace) { return sight; }
#endif

#ifdef NEEDS_PLACE
RaySight with_last_solid(RaySight sight, Trace trace) { return with_solid(with_matter(sight, trace, sight.solid.phi)); }
#else
RaySight with_last_solid(RaySight sight, Trace trace) { return sight; }
#endif

#ifdef EFFECT_DISC
// The disc's crossings, and what lies before them.
RaySight with_layers(RaySight sight, Trace trace) {
    DiscWalk walk = disc_walk(trace);
    do {   // tested at the end, see disc_cover
        DiscCrossing crossing = disc_walk_crossing(trace, walk);
        sight = with_matter(sight, trace, before_solid(sight, walk.more ? crossing.phi : 0.0));
        sight = with_solid_before(sight, crossing.phi);
        vec4 over = disc_colour(trace, crossing) * walk.covered;
        bool met = walk.more && crossing.hit;
        over = met ? over * sight.through : vec4(0.0);
        sight = with_stokes(sight, met ? walk.covered * sight.through : 0.0);
        sight.light += layer_light(over.rgb, over.a, LAYER_DISC + min(disc_walk_order(walk, crossing), 2));
        sight.through = max(sight.through - over.a, 0.0);   // a cover is 1 to rounding
        walk = disc_next(trace, walk);
    } while (walk.more && sight.through > SIGHT_LEAST);
    return sight;
}
#else
RaySight with_layers(RaySight sight, Trace trace) { return sight; }
#endif

#ifdef EFFECT_SKY
#ifdef NEEDS_SKY_OF_EVERY_RAY
bool ends_on_sky(Trace trace) { return true; }
#else
bool ends_on_sky(Trace trace) { return trace.escapes; }
#endif

RaySight with_sky(RaySight sight, Trace trace) {
    if (ends_on_sky(trace) && sight.through > SIGHT_LEAST)
        sight.light += layer_light(sight.through * celestial_sphere(trace, sky_fetches(trace)), sight.through, LAYER_SKY);
    return sight;
}
#else
#ifdef EFFECT_FAR_SKY
RaySight with_sky(RaySight sight, Trace trace) {
    if (!trace.escapes) sight.light += layer_light(sight.through * other_side(trace, sky_fetches(trace)), sight.through, LAYER_SKY);
    return sight;
}
#else
RaySight with_sky(RaySight sight, Trace trace) { return sight; }
#endif
#endif

#ifdef EFFECT_SKY_PATTERN
#ifdef EFFECT_BOUNCE
bool ends_on_painted(Trace trace) { return true; }
#else
bool ends_on_painted(Trace trace) { return trace.escapes; }
#endif

RaySight with_painted(RaySight sight, Trace trace) {
    if (ends_on_painted(trace) && sight.through > SIGHT_LEAST)
        sight.light += layer_light(sight.through * sky_pattern_light(trace), sight.through, LAYER_SKY);
    return sight;
}
#else
RaySight with_painted(RaySight sight, Trace trace) { return sight; }
#endif

// A black sky of a picture in layers, which can be replaced.
RaySight with_black(RaySight sight, Trace trace) {
#ifdef LAYERS
#ifndef EFFECT_SKY
#ifndef EFFECT_SKY_PATTERN
    if (trace.escapes) sight.light += layer_light(vec3(0.0), sight.through, LAYER_SKY);
#endif
#endif
#endif
    return sight;
}

#ifdef EFFECT_STAR
RaySight with_star(RaySight sight, Trace trace) {
    if (!trace.escapes) {
        sight.light += layer_light(sight.through * star_surface(trace), sight.through, LAYER_BODIES);
        sight.through = 0.0;
    }
    return sight;
}
#else
RaySight with_star(RaySight sight, Trace trace) { return sight; }
#endif

// What fragment_colour's a stands for.
float sight_rest(RaySight sight, Trace trace) {
#ifdef EFFECT_POINT_STARS
    return sight.through;
#else
#ifdef EFFECT_REFINE
    return path_way(trace);
#else
    return 0.0;
#endif
#endif
}

// What a ray meets: its light, and fragment_colour's a.
vec4 ray_light(vec2 pixel) {
    Trace trace = trace_pixel(pixel);
    RaySight sight;
    sight.light = vec3(0.0);
    sight.through = 1.0;
    sight.stokes = vec2(0.0);
    sight = sight_of_solid(sight, trace);
    sight = sight_of_matter(sight, trace, pixel);
    sight = with_layers(sight, trace);
    sight = with_last_solid(sight, trace);
    sight = with_matter_behind(sight, trace);
    sight = with_sky(sight, trace);
    sight = with_painted(sight, trace);
    sight = with_black(sight, trace);
    sight = with_star(sight, trace);
    return vec4(sight_light(sight), sight_rest(sight, trace));
}
