// A ray's light where the disc covers all: what it is at the crossing that the tile says.
#include "object/disc_colour.glsl"
#include "path/disc"
#include "path/trace"

#ifdef BY_COMPUTE
float tile_number;
#else
flat in highp float tile_number;   // stage/tile.vert
#endif

// Its light, and fragment_colour's a.
vec4 ray_light(vec2 pixel) {
    Trace trace = trace_pixel(pixel);
    vec4 disc = disc_colour(trace, disc_crossing_within(trace, int(tile_number)));
#ifdef EFFECT_POINT_STARS
    return vec4(disc.rgb, 1.0 - disc.a);
#else
#ifdef EFFECT_REFINE
    return vec4(disc.rgb, path_way(trace));
#else
    return vec4(disc.rgb, 0.0);
#endif
#endif
}
