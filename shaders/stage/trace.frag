// The picture: what each pixel's ray meets, front to back.
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
#include "effect/sampling.glsl"
#ifdef SLOT_MEDIUM
#include "path/medium"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/layer.glsl"
#include "stage/pixel.glsl"
#ifdef TILES_WITH_BODIES
#include "core/bits.glsl"
#include "generated/bodies_march"

flat in highp vec4 tile_set;   // stage/tile.vert
#endif

// What a ray meets: its light, and fragment_colour's a.
vec4 ray_light(vec2 pixel) {
    Trace trace = trace_pixel(pixel);
    vec3 light = vec3(0.0);
    float through = 1.0;
#ifdef NEEDS_PLACE
    // The first solid body: met once, laid between the disc's crossings before and behind it.
    SolidHit solid = solid_hit(trace, 1.0);
    vec4 body = solid.object == 0 ? vec4(0.0) : vec4(solid_light(trace, solid), 1.0) * solid.covered;
#endif
#ifdef SLOT_MEDIUM
    MediumWalk medium = medium_walk(trace, pixel);
#endif
#ifdef EFFECT_DISC
    DiscWalk walk = disc_walk(trace);
    do {   // tested at the end, see disc_cover
        DiscCrossing crossing = disc_walk_crossing(trace, walk);
#ifdef SLOT_MEDIUM
        float until = walk.more ? crossing.phi : 0.0;
#ifdef NEEDS_PLACE
        until = min(until, solid.phi);
#endif
        medium = medium_to(trace, medium, until);
        light += layer_light(through * medium.sum.light, through - through * medium.sum.through, LAYER_MEDIUM);
        through *= medium.sum.through;
#endif
#ifdef NEEDS_PLACE
        if (crossing.phi > solid.phi) {
            light += layer_light(through * body.rgb, through * body.a, LAYER_BODIES);
            through -= through * body.a;
            body = vec4(0.0);
        }
#endif
        vec4 over = disc_colour(trace, crossing) * walk.covered;
        over = walk.more && crossing.hit ? over * through : vec4(0.0);
        light += layer_light(over.rgb, over.a, LAYER_DISC + min(disc_walk_order(walk, crossing), 2));
        through -= over.a;
        walk = disc_next(trace, walk);
    } while (walk.more && through > 0.002);
#endif
#ifdef NEEDS_PLACE
#ifdef SLOT_MEDIUM
    medium = medium_to(trace, medium, solid.phi);
    light += layer_light(through * medium.sum.light, through - through * medium.sum.through, LAYER_MEDIUM);
    through *= medium.sum.through;
#endif
    light += layer_light(through * body.rgb, through * body.a, LAYER_BODIES);
    through -= through * body.a;
#endif
#ifdef SLOT_MEDIUM
    if (through > 0.002) {
        medium = medium_to(trace, medium, 1.0e30);
        light += layer_light(through * medium.sum.light, through - through * medium.sum.through, LAYER_MEDIUM);
        through *= medium.sum.through;
    }
#endif
#ifdef EFFECT_SKY
#ifdef NEEDS_SKY_OF_EVERY_RAY
    if (through > 0.002) light += layer_light(through * celestial_sphere(trace, sky_fetches(trace)), through, LAYER_SKY);
#else
    if (trace.escapes && through > 0.002) light += layer_light(through * celestial_sphere(trace, sky_fetches(trace)), through, LAYER_SKY);
#endif
#else
#ifdef EFFECT_FAR_SKY
    if (!trace.escapes) light += layer_light(through * other_side(trace, sky_fetches(trace)), through, LAYER_SKY);
#endif
#endif
#ifdef EFFECT_SKY_PATTERN
#ifdef EFFECT_BOUNCE
    if (through > 0.002) light += layer_light(through * sky_pattern_light(trace), through, LAYER_SKY);
#else
    if (trace.escapes && through > 0.002) light += layer_light(through * sky_pattern_light(trace), through, LAYER_SKY);
#endif
#endif
#ifdef LAYERS
#ifndef EFFECT_SKY
#ifndef EFFECT_SKY_PATTERN
    if (trace.escapes) light += layer_light(vec3(0.0), through, LAYER_SKY);   // a black one can be replaced
#endif
#endif
#endif
#ifdef EFFECT_STAR
    if (!trace.escapes) {
        light += layer_light(through * star_surface(trace), through, LAYER_BODIES);
        through = 0.0;
    }
#endif
#ifdef EFFECT_POINT_STARS
    return vec4(light, through);
#else
#ifdef EFFECT_REFINE
    return vec4(light, path_way(trace));
#else
    return vec4(light, 0.0);
#endif
#endif
}

out vec4 colour;

void main() {
#ifdef TILES_WITH_BODIES
#ifdef MARCH_LISTS
    bodies_shown = set_of(tile_set);
#endif
#endif
#ifdef NEEDS_SAMPLING
    int number = sampling_first();
    int left = sampling_count();
    vec4 sum = vec4(0.0);
    do {   // tested at the end, see disc_cover
        sum += fragment_light(ray_light(fragment_pixel(number)));
        ++number;
        --left;
    } while (left > 0);
    colour = fragment_colour(sum / float(sampling_count()));
#else
    colour = fragment_colour(fragment_light(ray_light(fragment_pixel(0))));
#endif
}
