// The picture where the disc covers all: what it is at the crossing that the tile says.
#include "effect/sampling.glsl"
#include "object/disc_colour.glsl"
#include "path/disc"
#include "path/trace"
#include "stage/pixel.glsl"

flat in highp float tile_number;   // stage/tile.vert

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

out vec4 colour;

void main() {
#ifdef EFFECT_SAMPLES
    int number = sampling_first();
    int left = sampling_count();
    vec4 sum = vec4(0.0);
    do {   // tested at the end, see disc_cover
        sum += ray_light(fragment_pixel(number));
        ++number;
        --left;
    } while (left > 0);
    colour = fragment_colour(sum / float(sampling_count()));
#else
    colour = fragment_colour(ray_light(fragment_pixel(0)));
#endif
}
