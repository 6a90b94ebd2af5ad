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
#ifdef MEDIUM_STOKES
vec3 sight_light(RaySight sight) { return layer_shown == LAYER_STOKES ? sight.medium.sum.stokes.stokes : sight.light; }
#else
vec3 sight_light(RaySight sight) { return layer_shown == LAYER_STOKES ? vec3(sight.stokes, 0.0) : sight.light; }
#endif
#else
vec3 sight_light(RaySight sight) { return sight.light; }
#endif

#ifdef NEEDS_DISC_STOKES
RaySight with_stokes(RaySight sight, float share) {
    sight.stokes += share > 0.0 ? share * disc_stokes : vec2(0.0);   // of no crossing it may be no number
    return sight;
}
#else
RaySight with_stokes(RaySight sight, float share) { return sight; }
#endif

#ifdef MEDIUM_STOKES
RaySight with_stokes_of(RaySight sight, vec3 light) {
    sight.medium.sum.stokes = stokes_of_behind(sight.medium.sum.stokes, light);
    return sight;
}
#else
RaySight with_stokes_of(RaySight sight, vec3 light) { return sight; }
#endif

// Light from behind all that was met, of what hides `share` of what is behind it.
#ifdef LAYERS
RaySight with_light(RaySight sight, vec3 light, float share, int layer) {
    sight.light += layer_light(sight.through * light, sight.through * share, layer);
    return with_stokes_of(sight, light);
}
#else
RaySight with_all_light(RaySight sight, vec3 light) {
    sight.light += sight.through * light;
    return sight;
}
#define with_light(sight, light, share, layer) with_all_light(sight, light)
#endif

// Behind what hides `cover`, besides sight.through.
#ifdef MEDIUM_STOKES
RaySight covered(RaySight sight, float cover) {
    sight.medium.sum.stokes = stokes_covered(sight.medium.sum.stokes, cover);
    return sight;
}
#else
RaySight covered(RaySight sight, float cover) { return sight; }
#endif

#ifdef NEEDS_PLACE
RaySight sight_of_solid(RaySight sight, Trace trace) {
    sight.solid = solid_hit(trace, 1.0);
    sight.body = sight.solid.object == 0 ? vec4(0.0) : vec4(solid_light(trace, sight.solid), 1.0) * sight.solid.covered;
    return sight;
}

float before_solid(RaySight sight, float along) { return min(along, sight.solid.phi); }

RaySight with_solid(RaySight sight) {
    sight = with_light(sight, sight.body.rgb, sight.body.a, LAYER_BODIES);
    sight.through -= sight.through * sight.body.a;
    return covered(sight, sight.body.a);
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
#ifdef MEDIUM_STOKES
RaySight with_matter(RaySight sight, Trace trace, float until) {
    sight.medium.sum.stokes.light = vec3(0.0);
    sight.medium = medium_to(trace, sight.medium, until);
    float left = medium_left(sight.medium.sum);
    sight.light += layer_light(medium_seen_light(sight.medium.sum), max(sight.through - left, 0.0), LAYER_MEDIUM);
    sight.through = left;
    return sight;
}
#else
RaySight with_matter(RaySight sight, Trace trace, float until) {
    sight.medium = medium_to(trace, sight.medium, until);
    sight.light += layer_light(sight.through * sight.medium.sum.light, sight.through - sight.through * sight.medium.sum.through, LAYER_MEDIUM);
    sight.through *= sight.medium.sum.through;
    return sight;
}
#endif

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
        over = met ? over : vec4(0.0);
        sight = with_stokes(sight, met ? walk.covered * sight.through : 0.0);
        sight = with_light(sight, over.rgb, over.a, LAYER_DISC + min(disc_walk_order(walk, crossing), 2));
        sight.through = max(sight.through - sight.through * over.a, 0.0);   // a cover is 1 to rounding
        sight = covered(sight, over.a);
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
        sight = with_light(sight, celestial_sphere(trace, sky_fetches(trace)), 1.0, LAYER_SKY);
    return sight;
}
#else
#ifdef EFFECT_FAR_SKY
RaySight with_sky(RaySight sight, Trace trace) {
    if (!trace.escapes) sight = with_light(sight, other_side(trace, sky_fetches(trace)), 1.0, LAYER_SKY);
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
        sight = with_light(sight, sky_pattern_light(trace), 1.0, LAYER_SKY);
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
    if (trace.escapes) sight = with_light(sight, vec3(0.0), 1.0, LAYER_SKY);
#endif
#endif
#endif
    return sight;
}

#ifdef EFFECT_STAR
RaySight with_star(RaySight sight, Trace trace) {
    if (!trace.escapes) {
        sight = with_light(sight, star_surface(trace), 1.0, LAYER_BODIES);
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
